//! The declarations of a data file.

use val3_syntax::xml::Element;

/// The elements that declare data: those of `<Datas>`, in s5 and s6 those of all sections.
pub(crate) fn elements(root: Element<'_>) -> impl Iterator<Item = Element<'_>> {
    let is_new = root.name() == "Database";
    let lists = root.elements().filter(move |list| !is_new || list.name() == "Datas");
    lists.flat_map(Element::elements).filter(move |element| !is_new || element.name() == "Data")
}
