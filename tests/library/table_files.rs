//! Tables in another format than CSV: long ones, block by block.

#[cfg(feature = "parquet")]
mod parquet_files {
    use std::fs;

    use crate::report::{Origin, ParquetTable};
    use crate::table::Column;
    use parquet::file::reader::{FileReader, SerializedFileReader};
    use parquet::record::Field;

    #[test]
    fn row_groups_follow_and_equal_rows_give_equal_bytes() {
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
