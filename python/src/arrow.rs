//! Tables as a stream of the Arrow C interface, which pandas, polars and pyarrow take.

use std::sync::Arc;

use arrow_array::ffi_stream::FFI_ArrowArrayStream;
use arrow_array::{
    ArrayRef, Float64Array, Int64Array, RecordBatch, RecordBatchIterator, StringArray,
};
use arrow_schema::{Field, Schema};
use numpy::{PyArray1, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyCapsule;

use crate::errors::other;

/// A capsule `arrow_array_stream` of columns by their names: numpy arrays of float64 (NaN is null) or int64, or lists
/// of words.
#[pyfunction]
pub fn arrow_stream<'py>(
    py: Python<'py>,
    names: Vec<String>,
    columns: Vec<Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyCapsule>> {
    let arrays = columns.iter().map(array).collect::<PyResult<Vec<_>>>()?;
    let fields = names.iter().zip(&arrays);
    let fields = fields.map(|(name, array)| Field::new(name, array.data_type().clone(), true));
    let schema = Arc::new(Schema::new(fields.collect::<Vec<_>>()));
    let batch = RecordBatch::try_new(schema.clone(), arrays).map_err(other)?;
    let reader = RecordBatchIterator::new([Ok(batch)], schema);
    let stream = FFI_ArrowArrayStream::new(Box::new(reader));
    PyCapsule::new_with_value(py, stream, c"arrow_array_stream")
}

fn array(column: &Bound<'_, PyAny>) -> PyResult<ArrayRef> {
    if let Ok(numbers) = column.cast::<PyArray1<f64>>() {
        let numbers = numbers.readonly();
        let numbers = numbers.as_array();
        let numbers = numbers
            .iter()
            .map(|value| Some(*value).filter(|v| !v.is_nan()));
        return Ok(Arc::new(numbers.collect::<Float64Array>()));
    }
    if let Ok(counts) = column.cast::<PyArray1<i64>>() {
        let counts = counts.readonly();
        return Ok(Arc::new(Int64Array::from_iter_values(
            counts.as_array().iter().copied(),
        )));
    }
    let words: Vec<String> = column.extract()?;
    Ok(Arc::new(StringArray::from_iter_values(words)))
}
