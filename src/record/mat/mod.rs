//! MATLAB version 5: variables, which hold numbers, texts, structs and cells.
//!
//! Matrices give a channel a column, or a row where there are fewer rows than columns; single numbers and texts are kept by
//! their names. A struct with fields `Name` and `Data` is a channel of that name.

mod reader;
mod variables;

use super::bytes::Bytes;
use super::{Problem, Record, RecordChannel};
use variables::Variables;

/// What a variable, field or cell holds.
#[derive(Default)]
enum Value {
    /// Nothing, or what is left out.
    #[default]
    Nothing,
    Text(String),
    /// The columns of a matrix, or its rows where these are longer.
    Series(Vec<Vec<f64>>),
    /// Real and imaginary parts.
    Complex([Vec<Vec<f64>>; 2]),
    Cells(Vec<Value>),
    Structs {
        names: Vec<String>,
        /// The fields of each element.
        elements: Vec<Vec<Value>>,
    },
}

/// Reads all variables.
pub(super) fn read(record: &mut Record, bytes: Bytes<'_>) -> Result<(), Problem> {
    let mut variables = Variables::new(bytes)?;
    while let Some((name, value)) = variables.next()? {
        // without a name MATLAB keeps the contents of its objects
        if !name.is_empty() {
            add(record, name, value)?;
        }
    }
    record.warnings.extend(variables.left_out);
    Ok(())
}

/// Adds what a value at this path holds.
fn add(record: &mut Record, path: String, value: Value) -> Result<(), Problem> {
    match value {
        Value::Nothing => {}
        Value::Text(text) => record.texts.push((path, text)),
        Value::Series(series) => match &series[..] {
            [single] if single.len() == 1 => record.numbers.push((path, single[0])),
            _ => {
                let mut channels = numbered(&path, series);
                channels.try_for_each(|(name, it)| record.add(RecordChannel::new(name, it)))?;
            }
        },
        Value::Complex([real, imaginary]) => {
            add(record, format!("{path}.real"), Value::Series(real))?;
            add(
                record,
                format!("{path}.imaginary"),
                Value::Series(imaginary),
            )?;
        }
        Value::Cells(cells) => {
            numbered(&path, cells).try_for_each(|(path, cell)| add(record, path, cell))?;
        }
        Value::Structs { names, elements } => {
            let mut elements = numbered(&path, elements);
            elements.try_for_each(|(path, fields)| add_struct(record, &path, &names, fields))?;
        }
    }
    Ok(())
}

/// Each of some elements with its path: `Y[1]`, `Y[2]`; one alone has the path itself.
fn numbered<T>(path: &str, elements: Vec<T>) -> impl Iterator<Item = (String, T)> {
    let is_one = elements.len() == 1;
    (1..)
        .zip(elements)
        .map(move |(number, element)| match is_one {
            true => (path.to_owned(), element),
            false => (format!("{path}[{number}]"), element),
        })
}

fn add_struct(
    record: &mut Record,
    path: &str,
    names: &[String],
    mut fields: Vec<Value>,
) -> Result<(), Problem> {
    let place = |name| names.iter().position(|known| known == name);
    let take_text = |fields: &mut [Value], name| {
        let field = &mut fields[place(name)?];
        let Value::Text(text) = field else {
            return None;
        };
        let text = std::mem::take(text);
        *field = Value::Nothing;
        Some(text)
    };
    if let Some(data) = place("Data")
        && let Some(name) = take_text(&mut fields, "Name")
    {
        let name = if name.is_empty() {
            format!("{path}.Data")
        } else {
            name
        };
        let before = record.channels.len();
        add(record, name, std::mem::take(&mut fields[data]))?;
        if let Some(unit) = take_text(&mut fields, "Unit")
            && !unit.trim().is_empty()
        {
            let channels = record.channels[before..].iter_mut();
            channels.for_each(|channel| channel.unit = Some(unit.clone()));
        }
    }
    let mut fields = names.iter().zip(fields);
    fields.try_for_each(|(name, value)| add(record, format!("{path}.{name}"), value))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::Form;

    fn record_of(fields: Vec<(&str, Value)>) -> Record {
        let mut record = Record::new(Form::Mat);
        let (names, fields): (Vec<_>, Vec<_>) = fields.into_iter().unzip();
        let names: Vec<String> = names.into_iter().map(str::to_owned).collect();
        add_struct(&mut record, "s", &names, fields).expect("few channels");
        record
    }

    #[test]
    fn a_struct_without_a_text_as_name_keeps_its_fields() {
        let data = || Value::Series(vec![vec![1.0, 2.0, 3.0]]);
        let text = |text: &str| Value::Text(text.to_owned());
        let number = |value| Value::Series(vec![vec![value]]);

        let unnamed = record_of(vec![("Data", data()), ("Fs", number(1000.0))]);
        assert_eq!(unnamed.channels[0].name, "s.Data");
        let numbered = record_of(vec![("Name", number(5.0)), ("Data", data())]);
        assert_eq!(numbered.channels[0].name, "s.Data");
        assert_eq!(numbered.numbers, [("s.Name".to_owned(), 5.0)]);
        let empty = record_of(vec![("Name", text("a"))]);
        assert_eq!(empty.texts, [("s.Name".to_owned(), "a".to_owned())]);

        let named = |unit| record_of(vec![("Data", data()), ("Unit", unit), ("Name", text("a"))]);
        let full = named(text("g"));
        assert_eq!(full.channels[0].name, "a");
        assert_eq!(full.channels[0].unit.as_deref(), Some("g"));
        assert!(full.texts.is_empty() && full.channels.len() == 1);
        assert_eq!(named(number(7.0)).numbers, [("s.Unit".to_owned(), 7.0)]);
    }
}
