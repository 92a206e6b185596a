//! Changed attributes of a parameter or local.

use val3_analysis::items::program::{LocalDecl, ParamDecl};
use val3_lang::types::Container;
use val3_syntax::xml::{Attribute, XmlElement, escaped};
use val3_syntax::{TextRange, TextSize, TextSlice};

use super::slots::SlotEdit;
use super::variables::{NewLocal, NewParameter};

/// Edits that convert the element of `old` to the declaration of `new`.
pub(super) fn of_parameter(text: &str, element: XmlElement<'_>, old: &ParamDecl, new: &NewParameter) -> Vec<SlotEdit> {
    let tag = Tag { text, element };
    let mut edits: Vec<SlotEdit> = tag.name_and_type(old.name.as_str(), &old.type_name, &new.name, &new.type_name);
    if (old.container, old.by_reference) == (new.container, new.by_reference) {
        return edits;
    }
    if element.attribute("byVal").is_some() || element.name() == "param" {
        edits.extend(tag.set("byVal", if new.by_reference { "false" } else { "true" }));
        return edits;
    }
    let (kind, dims) = match new.container {
        Container::Element => ("element", 1),
        Container::Array { dims } => ("array", dims),
        Container::Collection => ("collection", 1),
    };
    edits.extend(tag.set("xsi:type", kind));
    edits.extend(if new.by_reference { tag.set("use", "reference") } else { tag.by_value() });
    edits.extend(tag.dimensions(dims));
    edits
}

/// Like [`of_parameter`], for a local.
pub(super) fn of_local(text: &str, element: XmlElement<'_>, old: &LocalDecl, new: &NewLocal) -> Vec<SlotEdit> {
    let tag = Tag { text, element };
    let mut edits = tag.name_and_type(old.name.as_str(), &old.type_name, &new.name, &new.type_name);
    if old.sizes != new.sizes {
        let sizes: Vec<String> = new.sizes.iter().map(u32::to_string).collect();
        edits.extend(tag.set("size", &sizes.join(" ")));
    }
    edits
}

/// Start tag of a declaration.
struct Tag<'a> {
    text: &'a str,
    element: XmlElement<'a>,
}

impl Tag<'_> {
    fn name_and_type(&self, old_name: &str, old_type: &str, name: &str, type_name: &str) -> Vec<SlotEdit> {
        let name = (old_name != name).then(|| self.set("name", name)).flatten();
        let ty = (old_type != type_name).then(|| self.set("type", type_name)).flatten();
        name.into_iter().chain(ty).collect()
    }

    /// Edit that sets an attribute. A new attribute is appended.
    fn set(&self, name: &str, value: &str) -> Option<SlotEdit> {
        match self.element.attribute(name) {
            Some(attribute) if attribute.text() == value => None,
            Some(attribute) => Some((attribute.range, escaped(value))),
            None => {
                let last = self.element.attributes().last()?;
                let text = format!(" {name}=\"{}\"", escaped(value));
                Some((TextRange::empty(end(last)), text))
            }
        }
    }

    /// Edit that sets passing by value.
    fn by_value(&self) -> Option<SlotEdit> {
        let passing = self.element.attribute("use")?;
        if self.is_of_controller() { self.set("use", "value") } else { Some(self.without(passing)) }
    }

    fn dimensions(&self, dims: u8) -> Option<SlotEdit> {
        match self.element.attribute("dimensions") {
            Some(attribute) if dims == 1 && !self.is_of_controller() => Some(self.without(attribute)),
            None if dims == 1 => None,
            _ => self.set("dimensions", &dims.to_string()),
        }
    }

    /// Whether the controller wrote the element: it writes the passing before the container, and also `use="value"` and
    /// `dimensions="1"`, which the vendor's editor omits.
    fn is_of_controller(&self) -> bool {
        let place = |name| self.element.attribute(name).map(|attribute| attribute.range.start());
        place("use").zip(place("xsi:type")).is_some_and(|(passing, kind)| passing < kind)
    }

    /// Edit that removes the attribute and the whitespace before it.
    fn without(&self, attribute: Attribute<'_>) -> SlotEdit {
        let before = self.text.part(..usize::from(attribute.name_range.start()));
        let start = TextSize::of(before.trim_end());
        (TextRange::new(start, end(attribute)), String::new())
    }
}

/// Attribute end, after the closing quote.
fn end(attribute: Attribute<'_>) -> TextSize {
    attribute.range.end() + TextSize::of('"')
}
