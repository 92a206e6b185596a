//! The variables of `--local`: a type, a name and a container, as a programmer writes a parameter.

use val3_lang::types::{Arm, BaseType};

/// A variable of the scope.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Local {
    /// The type as files spell it; the name of a user type as it stands.
    ty: String,
    name: String,
    /// Sizes; `None` for a collection.
    sizes: Option<Vec<u32>>,
}

/// The arm of positions where nothing tells.
const ARM: Arm = Arm::SixAxis;

impl Local {
    /// Reads `num nVal`, `point pA[3]`, `num nM[2,4]`, `string sNames[""]`.
    pub(crate) fn parse(text: &str) -> Result<Self, String> {
        let wrong =
            || format!("`{text}` is no variable; write a type and a name, such as \"num nVal\" or \"point pA[3]\"");
        let (ty, rest) = text.trim().split_once(char::is_whitespace).ok_or_else(wrong)?;
        let (name, sizes) = match rest.trim().split_once('[') {
            None => (rest.trim(), Some(vec![1])),
            Some((name, inside)) => {
                (name.trim(), sizes(inside.strip_suffix(']').ok_or_else(wrong)?).ok_or_else(wrong)?)
            }
        };
        let is_name = !name.is_empty()
            && name.chars().all(|character| character.is_ascii_alphanumeric() || character == '_')
            && !name.starts_with(|first: char| first.is_ascii_digit());
        if !is_name {
            return Err(wrong());
        }
        let ty = BaseType::from_name(ty).map_or_else(|| ty.to_owned(), |ty| ty.file_name(ARM));
        Ok(Self { ty, name: name.to_owned(), sizes })
    }

    /// The variable as a data file declares it.
    pub(crate) fn data(&self) -> String {
        let Self { ty, name, sizes } = self;
        let shape = match sizes {
            None => r#"xsi:type="collection""#.to_owned(),
            Some(sizes) => {
                let sizes: Vec<String> = sizes.iter().map(ToString::to_string).collect();
                format!(r#"xsi:type="array" size="{}""#, sizes.join(" "))
            }
        };
        format!(r#"    <Data name="{name}" access="private" {shape} type="{ty}" />"#)
    }
}

/// Sizes, or `None` within for a collection.
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
    use super::Local;

    fn data(text: &str) -> String {
        Local::parse(text).map_or_else(|error| error, |local| local.data().trim().to_owned())
    }

    #[test]
    fn variables_as_a_programmer_writes_them() {
        assert_eq!(data("num nVal"), r#"<Data name="nVal" access="private" xsi:type="array" size="1" type="num" />"#);
        assert_eq!(
            data("joint jA[2,3]"),
            r#"<Data name="jA" access="private" xsi:type="array" size="2 3" type="jointRx" />"#
        );
        assert_eq!(data("string s[\"\"]"), r#"<Data name="s" access="private" xsi:type="collection" type="string" />"#);
    }

    #[test]
    fn what_is_none() {
        for text in ["num", "num 1a", "num a[", "num a[0]", "num a[1,2,3,4]", "num a b"] {
            assert!(data(text).contains("is no variable"), "{text}");
        }
    }
}
