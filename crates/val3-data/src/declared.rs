//! Declarations of a data file.

use val3_syntax::xml::Element;

/// Elements that declare data: in `<Datas>`, or in all sections of s5 and s6.
pub(crate) fn elements(root: Element<'_>) -> impl Iterator<Item = Element<'_>> {
    let is_new = root.name() == "Database";
    let lists = root.elements().filter(move |list| !is_new || list.name() == "Datas");
    lists.flat_map(Element::elements).filter(move |element| !is_new || element.name() == "Data")
}
