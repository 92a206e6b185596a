//! Parses one line of a listing: data, locals, parameters and program heads.

/// Types with which a declaration may begin, besides the project's user types.
const TYPES: &[&str] = &[
    "bool",
    "num",
    "string",
    "dio",
    "aio",
    "sio",
    "screen",
    "trsf",
    "frame",
    "tool",
    "mdesc",
    "point",
    "pointRx",
    "pointRs",
    "pointVrb",
    "joint",
    "jointRx",
    "jointRs",
    "jointVrb",
    "config",
    "configRx",
    "configRs",
    "configVrb",
];

/// An application variable, or a local.
#[derive(Debug, PartialEq)]
pub(crate) struct FixtureData {
    pub(crate) public: bool,
    pub(crate) ty: String,
    pub(crate) name: String,
    pub(crate) shape: FixtureBrackets,
    /// Text after `=`: a VAL 3 literal.
    pub(crate) value: Option<String>,
}

/// Content of the brackets after a declared name.
#[derive(Debug, PartialEq)]
pub(crate) enum FixtureBrackets {
    /// Sizes, one number for each dimension; without brackets, one element.
    Array(Vec<usize>),
    /// Keys.
    Collection(Vec<String>),
}

/// Head of a program.
#[derive(Debug, PartialEq)]
pub(crate) struct Head {
    pub(crate) public: bool,
    pub(crate) name: String,
    pub(crate) parameters: Vec<FixtureParameter>,
}

/// A parameter.
#[derive(Debug, PartialEq)]
pub(crate) struct FixtureParameter {
    pub(crate) ty: String,
    pub(crate) name: String,
    pub(crate) reference: bool,
    pub(crate) container: Container,
}

/// Form of a parameter's argument.
#[derive(Debug, PartialEq)]
pub(crate) enum Container {
    Element,
    Array { dims: usize },
    Collection,
}

/// Parses the declaration in `line`; `None` if it is no declaration.
///
/// `types` are the user types of the project.
#[track_caller]
pub(crate) fn data(line: &str, types: &[String]) -> Option<FixtureData> {
    let (access, rest) = access(line);
    let (ty, rest) = word(rest)?;
    let is_type = access.is_some() || TYPES.contains(&ty) || types.iter().any(|known| known == ty);
    if !is_type || !rest.starts_with(' ') {
        return None;
    }
    let (name, rest) = word(rest.trim_start())?;
    let (shape, rest) = shape(rest.trim_start());
    let value = match rest.trim().strip_prefix('=') {
        Some(value) => Some(value.trim().to_owned()),
        None if rest.trim().is_empty() => None,
        None => panic!("`{line}`: only `= value` may follow the name; write one declaration per line"),
    };
    if let Some(value) = &value {
        check_value(line, ty, &shape, value);
    }
    Some(FixtureData { public: access == Some("public"), ty: ty.to_owned(), name: name.to_owned(), shape, value })
}

/// Rejects an initial value that the data file would not contain.
#[track_caller]
fn check_value(line: &str, ty: &str, shape: &FixtureBrackets, value: &str) {
    let fits = match ty {
        "bool" => ["true", "false"].contains(&value),
        "num" => value.parse::<f64>().is_ok(),
        "string" => quoted(value).is_some_and(|(_, rest)| rest.is_empty()),
        _ => panic!("`{line}`: only `bool`, `num` and `string` have an initial value"),
    };
    assert!(fits, "`{line}`: `{value}` is no value of type `{ty}`");
    let is_empty = match shape {
        FixtureBrackets::Array(sizes) => sizes.contains(&0),
        FixtureBrackets::Collection(keys) => keys.is_empty(),
    };
    assert!(!is_empty, "`{line}`: there is no first element for the value `{value}`");
}

/// Parses the program head in `line`; `None` if it is no program head.
#[track_caller]
pub(crate) fn head(line: &str) -> Option<Head> {
    let (access, rest) = access(line);
    let rest = rest.strip_prefix("program ")?.trim();
    let inside = rest.split_once('(').and_then(|(name, inside)| Some((name, inside.strip_suffix(')')?)));
    let Some((name, inside)) = inside else { panic!("`{line}`: write `program name(parameters)`") };
    let parameters = split_outside_brackets(inside).into_iter().map(|text| parameter(text, line)).collect();
    Some(Head { public: access == Some("public"), name: name.trim().to_owned(), parameters })
}

#[track_caller]
fn parameter(text: &str, line: &str) -> FixtureParameter {
    let Some((ty, name)) = text.trim().split_once(' ') else { panic!("`{line}`: `{text}` is no parameter") };
    let (name, container) = match name.trim().strip_suffix(']').and_then(|name| name.split_once('[')) {
        None => (name.trim(), Container::Element),
        Some((name, "\"\"")) => (name, Container::Collection),
        Some((name, commas)) => (name, Container::Array { dims: commas.matches(',').count() + 1 }),
    };
    let reference = ty.ends_with('&');
    FixtureParameter { ty: ty.trim_end_matches('&').to_owned(), name: name.to_owned(), reference, container }
}

/// Splits a parameter list at commas outside of brackets.
fn split_outside_brackets(text: &str) -> Vec<&str> {
    let mut inside = false;
    let parts = text.split(|c| {
        match c {
            '[' => inside = true,
            ']' => inside = false,
            _ => {}
        }
        c == ',' && !inside
    });
    parts.filter(|part| !part.trim().is_empty()).collect()
}

fn access(line: &str) -> (Option<&str>, &str) {
    match line.split_once(' ') {
        Some((access @ ("public" | "private"), rest)) => (Some(access), rest.trim_start()),
        _ => (None, line),
    }
}

/// Splits `text` after the name at its start.
pub(crate) fn word(text: &str) -> Option<(&str, &str)> {
    let end = text.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(text.len());
    (end > 0).then(|| text.split_at(end))
}

#[track_caller]
fn shape(text: &str) -> (FixtureBrackets, &str) {
    let Some(inside) = text.strip_prefix('[') else {
        return (FixtureBrackets::Array(vec![1]), text);
    };
    if inside.trim_start().starts_with('"') {
        let (keys, rest) = keys(inside.trim_start());
        return (FixtureBrackets::Collection(keys), rest);
    }
    let Some((inside, rest)) = inside.split_once(']') else { panic!("`{text}`: `]` is missing") };
    let parts = inside.split(',').map(str::trim);
    let sizes = parts.map(|size| size.parse().unwrap_or_else(|_| panic!("`[{inside}]`: `{size}` is no size")));
    (FixtureBrackets::Array(sizes.collect()), rest)
}

/// Parses the keys at the start of `text`. Returns the keys and the text after the bracket. A single empty key means
/// that there are no keys.
#[track_caller]
fn keys(text: &str) -> (Vec<String>, &str) {
    let (mut keys, mut rest) = (Vec::new(), text);
    let rest = loop {
        let Some((key, after)) = quoted(rest) else { panic!("`[{text}`: `{rest}` is no key: write `\"key\"`") };
        keys.push(key.to_owned());
        let after = after.trim_start();
        match after.strip_prefix(',') {
            Some(next) => rest = next.trim_start(),
            None => break after,
        }
    };
    let Some(rest) = rest.strip_prefix(']') else { panic!("`[{text}`: `]` is missing") };
    if keys == [""] {
        keys.clear();
    }
    assert!(!keys.iter().any(String::is_empty), "`[{text}`: an empty key is for a collection without keys");
    (keys, rest)
}

/// Content of the string literal at the start of `text`, and the remaining text.
pub(crate) fn quoted(text: &str) -> Option<(&str, &str)> {
    text.strip_prefix('"')?.split_once('"')
}

#[cfg(test)]
mod tests {
    use super::{Container, FixtureBrackets, data, head};

    #[test]
    fn data_lines() {
        let pick = data("public point pPick[3,4]", &[]).unwrap();
        assert!(pick.public);
        assert_eq!((pick.ty.as_str(), pick.name.as_str()), ("point", "pPick"));
        assert_eq!(pick.shape, FixtureBrackets::Array(vec![3, 4]));
        assert_eq!(data("dio dIn[\"\"]", &[]).unwrap().shape, FixtureBrackets::Collection(vec![]));
        assert_eq!(data("string sName = \"box\"", &[]).unwrap().value.unwrap(), "\"box\"");
        assert_eq!(data("Slot tSlot", &["Slot".to_owned()]).unwrap().ty, "Slot");
    }

    #[test]
    fn keys_are_texts_in_quotes() {
        assert_eq!(keys("num nA[\"a,b\", \"c]=\"]"), ["a,b", "c]="]);
        assert_eq!(keys("num nA[ \"\" ]"), [""; 0]);
        assert_eq!(data("num nA[\"a,]\"] = 2", &[]).unwrap().value.unwrap(), "2");
    }

    fn keys(line: &str) -> Vec<String> {
        match data(line, &[]).unwrap().shape {
            FixtureBrackets::Collection(keys) => keys,
            FixtureBrackets::Array(_) => panic!("`{line}` is an array"),
        }
    }

    #[test]
    #[should_panic(expected = "`b]` is no key: write `\"key\"`")]
    fn a_key_without_quotes() {
        data("num nA[\"a\",b]", &[]);
    }

    #[test]
    #[should_panic(expected = "`]` is missing")]
    fn keys_without_an_end() {
        data("num nA[\"a\" = 1", &[]);
    }

    #[test]
    #[should_panic(expected = "an empty key is for a collection without keys")]
    fn an_empty_key_among_others() {
        data("num nA[\"a\",\"\"]", &[]);
    }

    #[test]
    fn initial_values_fit_their_type() {
        for line in ["num nA = -1.5e3", "bool bA=true", "string sA = \"=[a]\"", "num nA[2,3] = 1", "num nA[\"a\"] = 1"]
        {
            assert!(data(line, &[]).unwrap().value.is_some(), "{line}");
        }
    }

    /// Panic message for an invalid line.
    fn mistake(line: &'static str) -> String {
        let caught = std::panic::catch_unwind(|| data(line, &[]));
        *caught.expect_err(line).downcast::<String>().unwrap()
    }

    #[test]
    fn values_that_no_file_can_have_are_mistakes() {
        for line in
            ["num nA = x", "num nA =", "num nA = \"1\"", "bool bA = 1", "string sA = box", "string sA = \"a\"+\"b\""]
        {
            assert!(mistake(line).contains("is no value of type"), "{line}");
        }
        for line in ["trsf tA = {0,0,0,0,0,0}", "dio dA = \"x\""] {
            assert!(mistake(line).contains("only `bool`, `num` and `string` have an initial value"), "{line}");
        }
        for line in ["num nA[\"\"] = 1", "num nA[0] = 1"] {
            assert!(mistake(line).contains("there is no first element"), "{line}");
        }
    }

    #[test]
    fn code_is_no_data() {
        for code in ["nA=1", "config(jA)", "call pick(nA)", "Slot tSlot", "if bA"] {
            assert_eq!(data(code, &[]), None, "{code}");
        }
    }

    #[test]
    fn heads() {
        let head = head("program pick(num x_n, num& x_g[,], string& x_c[\"\"])").unwrap();
        let shapes: Vec<_> = head.parameters.iter().map(|it| (it.reference, &it.container)).collect();
        let grid = Container::Array { dims: 2 };
        assert_eq!(shapes, [(false, &Container::Element), (true, &grid), (true, &Container::Collection)]);
    }
}
