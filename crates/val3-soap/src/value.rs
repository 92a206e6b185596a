//! Values of elements: numbers, texts, and the fields of structures.

use crate::document::SoapElement;
use crate::error::SoapError;
use crate::server::SoapServer;

/// Element content.
pub trait SoapValue: Sized {
    /// Reads the element's content.
    ///
    /// # Errors
    /// The content has another type.
    fn read(element: &SoapElement) -> Result<Self, SoapError>;

    /// Adds the content to an element.
    fn write(&self, element: &mut SoapElement);
}

/// Operation of a server: the request, and the names of request and answer.
pub trait Operation: SoapValue {
    /// Server of the operation.
    const SERVER: SoapServer;
    /// Name of the operation and of the request's element.
    const NAME: &'static str;
    /// Name of the answer's element.
    const ANSWER: &'static str;
    /// Whether the operation requires a session.
    const NEEDS_SESSION: bool;
    /// Content of the answer.
    type Answer: SoapValue;
}

/// Empty element content.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Empty;

impl SoapValue for Empty {
    fn read(_: &SoapElement) -> Result<Self, SoapError> {
        Ok(Self)
    }

    fn write(&self, _: &mut SoapElement) {}
}

impl SoapValue for String {
    fn read(element: &SoapElement) -> Result<Self, SoapError> {
        element.leaf_text("a text").map(str::to_owned)
    }

    fn write(&self, element: &mut SoapElement) {
        element.text.push_str(self);
    }
}

impl SoapValue for i32 {
    fn read(element: &SoapElement) -> Result<Self, SoapError> {
        let expected = "a whole number";
        let text = element.leaf_text(expected)?.trim();
        text.parse().map_err(|_| SoapError::wrong_value(&element.name, text, expected))
    }

    fn write(&self, element: &mut SoapElement) {
        element.text.push_str(&self.to_string());
    }
}

impl SoapValue for f64 {
    /// Reads a finite number. The words `NaN` and `INF` are rejected, because no quantity of the interface has them.
    fn read(element: &SoapElement) -> Result<Self, SoapError> {
        let expected = "a finite number";
        let text = element.leaf_text(expected)?.trim();
        let number = text.parse().ok().filter(|number: &Self| number.is_finite());
        number.ok_or_else(|| SoapError::wrong_value(&element.name, text, expected))
    }

    fn write(&self, element: &mut SoapElement) {
        element.text.push_str(&self.to_string());
    }
}

impl SoapValue for bool {
    fn read(element: &SoapElement) -> Result<Self, SoapError> {
        let expected = "true or false";
        match element.leaf_text(expected)?.trim() {
            "true" | "1" => Ok(true),
            "false" | "0" => Ok(false),
            text => Err(SoapError::wrong_value(&element.name, text, expected)),
        }
    }

    fn write(&self, element: &mut SoapElement) {
        element.text.push_str(if *self { "true" } else { "false" });
    }
}

/// Field of a structure.
pub(crate) trait SoapField: Sized {
    /// Reads the field from its child elements of `parent`.
    fn read_field(parent: &SoapElement, name: &'static str) -> Result<Self, SoapError>;

    /// Adds the field to an element.
    fn write_field(&self, name: &'static str, parent: &mut SoapElement);
}

impl<T: SoapValue> SoapField for T {
    fn read_field(parent: &SoapElement, name: &'static str) -> Result<Self, SoapError> {
        let child = only_child(parent, name)?;
        T::read(child.ok_or_else(|| SoapError::Missing { name, parent: parent.name.clone() })?)
    }

    fn write_field(&self, name: &'static str, parent: &mut SoapElement) {
        let mut child = SoapElement::plain(name);
        self.write(&mut child);
        parent.children.push(child);
    }
}

impl<T: SoapValue> SoapField for Option<T> {
    /// Reads an element that may be missing, or state that it has no value.
    fn read_field(parent: &SoapElement, name: &'static str) -> Result<Self, SoapError> {
        only_child(parent, name)?.filter(|child| !child.is_nil()).map(T::read).transpose()
    }

    fn write_field(&self, name: &'static str, parent: &mut SoapElement) {
        if let Some(value) = self {
            value.write_field(name, parent);
        }
    }
}

impl<T: SoapValue> SoapField for Vec<T> {
    fn read_field(parent: &SoapElement, name: &'static str) -> Result<Self, SoapError> {
        children(parent, name).map(|child| child.and_then(T::read)).collect()
    }

    fn write_field(&self, name: &'static str, parent: &mut SoapElement) {
        self.iter().for_each(|item| item.write_field(name, parent));
    }
}

/// Children with this name. A child in a name space is an error, because clients write such children by mistake.
fn children<'a>(
    parent: &'a SoapElement,
    name: &'static str,
) -> impl Iterator<Item = Result<&'a SoapElement, SoapError>> {
    parent.children.iter().filter(move |child| child.name == name).map(move |child| {
        if child.namespace.is_empty() {
            return Ok(child);
        }
        Err(SoapError::Qualified { name, namespace: child.namespace.clone() })
    })
}

/// Only child with this name; `None` if the element has no such child.
pub(crate) fn only_child<'a>(
    parent: &'a SoapElement,
    name: &'static str,
) -> Result<Option<&'a SoapElement>, SoapError> {
    let mut children = children(parent, name);
    let child = children.next().transpose()?;
    if children.next().is_some() {
        return Err(SoapError::Repeated { name });
    }
    Ok(child)
}

/// Reads the items of a list: an element that contains one element for each item.
pub(crate) fn read_list<T: SoapValue>(
    parent: &SoapElement,
    name: &'static str,
    item: &'static str,
) -> Result<Vec<T>, SoapError> {
    let list = only_child(parent, name)?.ok_or_else(|| SoapError::Missing { name, parent: parent.name.clone() })?;
    Vec::read_field(list, item)
}

/// Adds a list to an element.
pub(crate) fn write_list<T: SoapValue>(items: &[T], name: &'static str, item: &'static str, parent: &mut SoapElement) {
    let mut list = SoapElement::plain(name);
    items.iter().for_each(|value| value.write_field(item, &mut list));
    parent.children.push(list);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read<T: SoapValue>(text: &str) -> Result<T, String> {
        T::read(&SoapElement::plain("x").with_text(text)).map_err(|error| error.to_string())
    }

    #[test]
    fn numbers_are_decimal_or_have_an_exponent() {
        assert_eq!(read::<f64>(" 0.040000000000000001\n"), Ok(0.04));
        assert_eq!(read::<f64>("-1E-3"), Ok(-0.001));
        for text in ["", "inf", "INF", "NaN", "1e999", "1,5", "0x1", "1 2"] {
            assert!(read::<f64>(text).is_err(), "{text}");
        }
        assert_eq!(
            read::<i32>("2147483648"),
            Err("the element `x` must contain a whole number, not `2147483648`".into())
        );
    }

    #[test]
    fn truth_values_have_two_spellings() {
        assert_eq!(["true", "1", "false", "0"].map(read::<bool>), [Ok(true), Ok(true), Ok(false), Ok(false)]);
        assert!(read::<bool>("TRUE").is_err());
    }

    #[test]
    fn long_texts_are_abbreviated_in_messages() {
        let error = read::<bool>(&"ä".repeat(100)).unwrap_err();
        assert!(error.contains("ä…`") && error.len() < 150, "{error}");
    }
}
