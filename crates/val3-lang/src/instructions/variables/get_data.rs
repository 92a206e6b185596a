//! `getData` (2.5.4): copies the value of a variable whose name is a string.

use std::sync::Arc;

use crate::call::Call;
use crate::declare::instruction;
use crate::fault::Result;
use crate::memory::{ContainerShape, Store, ValueType, View};
use crate::values::Text;

instruction! {
    /// Copies the value of a variable whose name is a string.
    ///
    /// - `sDataName`: `"name"`, `"library:name"`, or either with an index such as `"name[3]"`, at which copying starts.
    /// - `variable`: the destination, of the same type. If both are one-dimensional arrays, as many values are copied
    ///   as both contain, from the index of the destination on.
    /// - Result: the number of values copied; -1 no such variable, -2 no such library identifier, -3 index out of
    ///   range, -4 another type.
    ///
    /// ## Example
    /// ```val3
    /// library part "Disk://part/part.pjx"
    /// point pPath[20]
    /// num nPoints
    ///   nPoints=getData("part:pTrack",pPath)
    ///   if nPoints<0
    ///     logMsg("no track in the library")
    ///   endIf
    /// --- part
    /// public point pTrack[5]
    /// ```
    "getData": Variables "2.5.4";
    modifier (string sDataName, any& variable) -> num = get_data;
}

const NO_DATA: f64 = -1.0;
const NO_INDEX: f64 = -3.0;
const OTHER_TYPE: f64 = -4.0;

/// Copies elements from the index of each side on. Data with several dimensions or keys never match the type of the
/// variable.
fn get_data(call: &mut Call<'_>, name: Text, variable: View) -> Result<f64> {
    let source = match find(call, &name) {
        Ok(source) => source,
        Err(code) => return Ok(code),
    };
    let (from, to) = (call.memory.store(source.store)?, call.memory.store(variable.store)?);
    if !is_row(to) || !from.kind.suits(&to.kind) {
        return Ok(OTHER_TYPE);
    }
    let kind = Arc::clone(&from.kind);
    copy(call, &kind, source, variable)
}

fn is_row(store: &Store) -> bool {
    matches!(store.shape, ContainerShape::Array { dims: 1, .. })
}

/// Finds the data with this name, from its index on. An invalid name means that there are no such data.
fn find(call: &Call<'_>, name: &str) -> std::result::Result<View, f64> {
    let (name, index) = match name.split_once('[') {
        None => (name, 0.0),
        Some((name, index)) => {
            let index = index.strip_suffix(']').and_then(|index| index.trim().parse().ok());
            (name, index.ok_or(NO_DATA)?)
        }
    };
    let view = call.tasks.data(name).map_err(f64::from)?;
    let store = call.memory.store(view.store).map_err(|_| NO_DATA)?;
    if !is_row(store) {
        return Err(OTHER_TYPE);
    }
    let start = store.number1(view, index).map_err(|_| NO_INDEX)?;
    Ok(View { start, ..view })
}

/// Copies as many elements as both containers have. If elements move upwards within one array, the last element is
/// copied first.
fn copy(call: &mut Call<'_>, kind: &ValueType, source: View, target: View) -> Result<f64> {
    let count = call.memory.len(source)?.min(call.memory.len(target)?);
    let upwards = source.store == target.store && source.start < target.start;
    for number in 0..count {
        let number = if upwards { count - 1 - number } else { number };
        let (from, to) = (call.memory.element(source, number)?, call.memory.element(target, number)?);
        call.memory.copy(kind, from, to)?;
    }
    Ok(f64::from(count))
}

#[cfg(test)]
mod tests {
    use crate::testing::Bench;

    /// A test bench with the variables of the library `part`.
    fn bench() -> Bench {
        let declared = r#"num nTrack[3]; num nCount; num nGrid[2,2]; num nColl[""]; string sName"#;
        let mut bench =
            Bench::default().global(declared).local("num l_nPath[5]; num l_nOne; string l_sText; num nSelf[4]");
        for name in ["nTrack", "nCount", "nGrid", "nColl", "sName"] {
            bench.tasks.data.insert(format!("part:{name}"), bench.view(name));
        }
        bench.tasks.data.insert("nSelf".to_owned(), bench.view("nSelf"));
        bench.tasks.libraries = vec!["part"];
        bench.with("nTrack", &[1.0, 2.0, 3.0]).with("nCount", &[7.0]).with_texts("sName", &["bolt"])
    }

    #[track_caller]
    fn check(line: &str, code: &str, variable: &str, values: &str) {
        let mut bench = bench();
        assert_eq!([bench.run(line), bench.show(variable)], [code, values], "{line}");
    }

    #[test]
    fn an_element_gets_one_value() {
        check(r#"getData("part:nCount",l_nOne)"#, "1", "l_nOne", "7");
        check(r#"getData("part:nTrack",l_nOne)"#, "1", "l_nOne", "1");
        check(r#"getData("part:nTrack[2]",l_nOne)"#, "1", "l_nOne", "3");
        check(r#"getData("part:sName",l_sText)"#, "1", "l_sText", r#""bolt""#);
    }

    /// Example of the manual: two arrays, one after the other.
    #[test]
    fn an_array_gets_the_values_that_both_have() {
        let mut bench = bench();
        assert_eq!(bench.run(r#"getData("part:nTrack",l_nPath)"#), "3");
        assert_eq!(bench.show("l_nPath"), "1, 2, 3, 0, 0");
        assert_eq!(bench.run(r#"getData("part:nTrack",l_nPath[3])"#), "2");
        assert_eq!(bench.show("l_nPath"), "1, 2, 3, 1, 2");
        assert_eq!(bench.run(r#"getData("part:nTrack[1]",l_nPath[1])"#), "2");
        assert_eq!(bench.show("l_nPath"), "1, 2, 3, 1, 2");
    }

    #[test]
    fn an_array_can_be_moved_within_itself() {
        let mut bench = bench().with("nSelf", &[1.0, 2.0, 3.0, 4.0]);
        assert_eq!([bench.run(r#"getData("nSelf",nSelf[1])"#), bench.show("nSelf")], ["3", "1, 1, 2, 3"]);
        assert_eq!([bench.run(r#"getData("nSelf[2]",nSelf)"#), bench.show("nSelf")], ["2", "2, 3, 2, 3"]);
    }

    #[test]
    fn codes_give_the_reason_why_nothing_is_copied() {
        check(r#"getData("part:nOther",l_nOne)"#, "-1", "l_nOne", "0");
        check(r#"getData("nCount",l_nOne)"#, "-1", "l_nOne", "0");
        check(r#"getData("tools:nCount",l_nOne)"#, "-2", "l_nOne", "0");
        check(r#"getData("part:nTrack[3]",l_nOne)"#, "-3", "l_nOne", "0");
        check(r#"getData("part:nTrack[-1]",l_nOne)"#, "-3", "l_nOne", "0");
        check(r#"getData("part:sName",l_nOne)"#, "-4", "l_nOne", "0");
        check(r#"getData("part:nGrid",l_nOne)"#, "-4", "l_nOne", "0");
        check(r#"getData("part:nColl",l_nOne)"#, "-4", "l_nOne", "0");
        check(r#"getData("part:nTrack",nGrid)"#, "-4", "nGrid", "0, 0, 0, 0");
    }

    #[test]
    fn texts_that_are_no_names_find_no_data() {
        for name in ["", "part:", "part:nTrack[", "part:nTrack[]", "part:nTrack[x]", "part:nTrack[0", "part:nTrack]"] {
            check(&format!("getData(\"{name}\",l_nOne)"), "-1", "l_nOne", "0");
        }
    }
}
