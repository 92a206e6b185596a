//! Variables of evaluated code: a type, a name and a container, written like a parameter.

use val3_lang::types::{Arm, BaseType, DefaultValue, attributes, field};

/// A declared variable.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct ScratchVariable {
    /// Type name as in programs.
    ty: String,
    name: String,
    /// Sizes; `None` for a collection.
    sizes: Option<Vec<u32>>,
}

impl ScratchVariable {
    /// Parses `num nVal`, `point pA[3]`, `num nM[2,4]`, `string sNames[""]`.
    pub(crate) fn parse(text: &str) -> Result<Self, String> {
        Self::parsed(text).ok_or_else(|| {
            format!(
                "`{text}` is not a declaration of a variable; write a type and a name, such as \"num nVal\" or \"point pA[3]\""
            )
        })
    }

    fn parsed(text: &str) -> Option<Self> {
        let (ty, rest) = text.trim().split_once(char::is_whitespace)?;
        let (name, sizes) = match rest.trim().split_once('[') {
            None => (rest.trim(), Some(vec![1])),
            Some((name, inside)) => (name.trim(), sizes(inside.strip_suffix(']')?)?),
        };
        let is_name = !name.is_empty()
            && name.chars().all(|character| character.is_ascii_alphanumeric() || character == '_')
            && !name.starts_with(|first: char| first.is_ascii_digit());
        if !is_name {
            return None;
        }
        Some(Self { ty: ty.to_owned(), name: name.to_owned(), sizes })
    }

    /// Name.
    pub(crate) fn name(&self) -> &str {
        &self.name
    }

    /// Whether it is an array or a collection.
    pub(crate) fn is_container(&self) -> bool {
        self.sizes.as_deref() != Some(&[1])
    }

    /// Declaration of the variable in a data file with positions for this kind of arm.
    pub(crate) fn data(&self, arm: Arm) -> String {
        let Self { ty, name, sizes } = self;
        let ty = BaseType::from_name(ty).map_or_else(|| ty.clone(), |ty| ty.file_name(arm));
        let values = self.values(&ty);
        let shape = match sizes {
            None => r#"xsi:type="collection""#.to_owned(),
            Some(sizes) => {
                let sizes: Vec<String> = sizes.iter().map(ToString::to_string).collect();
                format!(r#"xsi:type="array" size="{}""#, sizes.join(" "))
            }
        };
        format!(r#"    <Data name="{name}" access="private" {shape} type="{ty}">{values}</Data>"#)
    }

    /// Initial values of a local variable, where they differ from the defaults of files (`mdesc`). `ty` is the type as
    /// spelled in files.
    fn values(&self, ty: &str) -> String {
        let begun = BaseType::from_file_name(ty).map(|(ty, arm)| begun(ty, arm)).unwrap_or_default();
        let keys = self.sizes.iter().filter(|_| !begun.is_empty()).flat_map(|sizes| keys(sizes));
        keys.map(|key| format!(r#"<Value key="{key}"{begun} />"#)).collect()
    }
}

/// Attributes of a value whose default in a program differs from the default in a file.
fn begun(ty: BaseType, arm: Option<Arm>) -> String {
    let differing = attributes(ty, arm).iter().filter_map(|attribute| match field(ty, arm, attribute.field)?.default {
        DefaultValue::Number(number) if attribute.default != DefaultValue::Number(number) => {
            Some(format!(r#" {}="{number}""#, attribute.name))
        }
        _ => None,
    });
    differing.collect()
}

/// Array indexes as spelled in files: `0,0`, `0,1`, …
fn keys(sizes: &[u32]) -> Vec<String> {
    sizes.iter().fold(vec![String::new()], |keys, size| {
        let longer = |key: &String, index| if key.is_empty() { format!("{index}") } else { format!("{key},{index}") };
        keys.iter().flat_map(|key| (0..*size).map(move |index| longer(key, index))).collect()
    })
}

/// Parses sizes; the inner `None` stands for a collection.
#[expect(clippy::option_option, reason = "outside: cannot be read; inside: a collection has no sizes")]
fn sizes(text: &str) -> Option<Option<Vec<u32>>> {
    if text.trim() == "\"\"" {
        return Some(None);
    }
    let sizes: Option<Vec<u32>> =
        text.split(',').map(|size| size.trim().parse().ok().filter(|size| *size > 0)).collect();
    sizes.filter(|sizes| sizes.len() <= 3).map(Some)
}

#[cfg(test)]
mod tests {
    use super::{Arm, ScratchVariable};

    fn data(text: &str) -> String {
        ScratchVariable::parse(text).map_or_else(|error| error, |local| local.data(Arm::SixAxis).trim().to_owned())
    }

    #[test]
    fn positions_are_for_the_arm() {
        let data = ScratchVariable::parse("point pA").unwrap().data(Arm::Scara);
        assert!(data.contains("type=\"pointRs\""), "{data}");
    }

    #[test]
    fn variables_are_declared_like_in_programs() {
        assert_eq!(
            data("num nVal"),
            r#"<Data name="nVal" access="private" xsi:type="array" size="1" type="num"></Data>"#
        );
        assert_eq!(
            data("joint jA[2,3]"),
            r#"<Data name="jA" access="private" xsi:type="array" size="2 3" type="jointRx"></Data>"#
        );
        assert_eq!(
            data("string s[\"\"]"),
            r#"<Data name="s" access="private" xsi:type="collection" type="string"></Data>"#
        );
    }

    #[test]
    fn variables_have_initial_values() {
        let value = |key| format!(r#"<Value key="{key}" tmax="9999" rmax="9999" />"#);
        for (text, keys) in [("mdesc m", &["0"][..]), ("mdesc m[2,2]", &["0,0", "0,1", "1,0", "1,1"])] {
            let values: String = keys.iter().map(value).collect();
            assert!(data(text).ends_with(&format!(">{values}</Data>")), "{}", data(text));
        }
        assert!(data("mdesc m[\"\"]").ends_with("></Data>"));
    }

    #[test]
    fn wrong_variables_are_refused() {
        for text in ["num", "num 1a", "num a[", "num a[0]", "num a[1,2,3,4]", "num a b"] {
            assert!(data(text).contains("is not a declaration"), "{text}");
        }
    }
}
