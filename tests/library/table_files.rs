//! Tables in other formats than CSV: long ones, block by block.

use crate::report::{MatTable, Origin};
use crate::table::Column;
use matfile::{MatFile, NumericData};

#[test]
fn a_mat_file_of_many_blocks_is_put_together_in_order() {
    let folder = tempfile::tempdir().unwrap();
    let columns = [
        Column::number("t", ""),
        Column::number("x", "m"),
        Column::count("n"),
    ];
    let origin = Origin {
        scenario: "{}".to_owned(),
    };
    for count in [0u32, 1, 8191, 8192, 8193, 20_000] {
        let scratch = folder.path().join("rows");
        let mut table = MatTable::new(Vec::new(), &columns, &origin, &scratch).unwrap();
        for row in 0..count {
            let row = f64::from(row);
            table.row(&[row, row.sqrt(), row % 3.0]).unwrap();
        }
        let bytes = table.finish().unwrap();
        assert!(!scratch.exists());
        assert_eq!(bytes.len() % 8, 0);
        if count == 0 {
            continue; // the reader knows no empty matrix
        }
        let mat = MatFile::parse(&bytes[..]).unwrap();
        let x = mat.find_by_name("x_m").unwrap();
        assert_eq!(x.size(), &vec![count as usize, 1]);
        let NumericData::Double { real, .. } = x.data() else {
            panic!("{:?}", x.data());
        };
        let expected: Vec<f64> = (0..count).map(|row| f64::from(row).sqrt()).collect();
        assert!(*real == expected);
    }
}

#[cfg(feature = "parquet")]
mod parquet_files {
    use std::fs;

    use crate::report::{Origin, ParquetTable};
    use crate::table::Column;
    use parquet::file::reader::{FileReader, SerializedFileReader};
    use parquet::record::Field;

    #[test]
    fn row_groups_follow_each_other_and_the_same_rows_give_the_same_bytes() {
        let columns: Vec<Column> = (0..64)
            .map(|n| Column::number(format!("c{n}"), ""))
            .collect();
        let origin = Origin {
            scenario: "{}".to_owned(),
        };
        let write = || {
            let mut table = ParquetTable::new(Vec::new(), &columns, &origin).unwrap();
            for row in 0..40_000 {
                table.row(&[f64::from(row); 64]).unwrap();
            }
            table.finish().unwrap()
        };
        let bytes = write();
        assert!(bytes == write());
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("table.parquet");
        fs::write(&path, bytes).unwrap();
        let reader = SerializedFileReader::new(fs::File::open(path).unwrap()).unwrap();
        assert_eq!(reader.metadata().num_row_groups(), 3);
        let rows = reader.get_row_iter(None).unwrap().enumerate();
        for (number, row) in rows {
            let row = row.unwrap();
            let (_, last) = row.get_column_iter().last().unwrap();
            assert_eq!(*last, Field::Double(number as f64));
        }
    }
}
