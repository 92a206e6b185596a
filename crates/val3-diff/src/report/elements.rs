//! Short notation for elements of a variable.

use val3_syntax::TextSlice;

/// Splits a data path into variable, key and field: `tSlot`, `3`, `.pPick` for `tSlot[3].pPick`.
pub(super) fn parts(path: &str) -> (&str, &str, &str) {
    let Some((name, rest)) = path.split_once('[') else {
        return path.split_once('.').map_or((path, "", ""), |(name, _)| (name, "", path.part(name.len()..)));
    };
    let (key, field) = rest.split_once(']').unwrap_or((rest, ""));
    // The first index may belong to a field: `tSlot.pPick[3]`.
    if name.contains('.') { (path, "", "") } else { (name, key, field) }
}

/// Formats elements of a variable with the same field: `pPick[0–3, 7]`, `tSlot["a"; "b"].pPick`.
pub(super) fn elements(paths: &[&str]) -> String {
    let Some((name, _, field)) = paths.first().map(|path| parts(path)) else { return String::new() };
    format!("{name}{}{field}", keys(paths))
}

/// Formats keys: `[0–3, 7]`, `["a"; "b"]`; empty for single data.
fn keys(paths: &[&str]) -> String {
    let keys: Vec<&str> = paths.iter().map(|path| parts(path).1).collect();
    if keys.iter().all(|key| key.is_empty()) {
        return String::new();
    }
    // Element 0 is shown without an index.
    let number = |key: &&str| if key.is_empty() { Some(0) } else { key.parse::<usize>().ok() };
    let numbers: Option<Vec<usize>> = keys.iter().map(number).collect();
    let (shown, separator) = match numbers {
        Some(numbers) => (ranges(numbers), ", "),
        // Indexes with several dimensions contain commas.
        None => (keys.iter().map(|key| (*key).to_owned()).collect(), "; "),
    };
    format!("[{}]", shown.join(separator))
}

/// Formats ranges: `0–3`, `7`.
pub(super) fn ranges(mut numbers: Vec<usize>) -> Vec<String> {
    numbers.sort_unstable();
    let mut found: Vec<(usize, usize)> = Vec::new();
    for number in numbers {
        match found.last_mut() {
            Some((_, last)) if number <= *last + 1 => *last = number,
            _ => found.push((number, number)),
        }
    }
    let ranges = found.into_iter().map(|(first, last)| match first == last {
        true => first.to_string(),
        false => format!("{first}–{last}"),
    });
    ranges.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn indexes_that_follow_each_other_are_a_range() {
        assert_eq!(elements(&["pA", "pA[1]", "pA[7]"]), "pA[0–1, 7]");
        assert_eq!(elements(&["tS[\"a\"].pB", "tS[\"b\"].pB"]), "tS[\"a\"; \"b\"].pB");
        assert_eq!(elements(&["nA"]), "nA");
        assert_eq!(elements(&["tS[0,1].pB", "tS[0,2].pB"]), "tS[0,1; 0,2].pB");
    }
}
