//! Lists without repetitions.

/// Every one once, where it comes first.
pub fn each_once<T: PartialEq>(all: impl IntoIterator<Item = T>) -> Vec<T> {
    let mut kept = Vec::new();
    for one in all {
        if !kept.contains(&one) {
            kept.push(one);
        }
    }
    kept
}

/// Every number once, the lowest first.
pub fn rising(all: impl IntoIterator<Item = f64>) -> Vec<f64> {
    let mut numbers: Vec<f64> = all.into_iter().collect();
    numbers.sort_by(f64::total_cmp);
    numbers.dedup();
    numbers
}
