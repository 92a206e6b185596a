//! Declarations of a data file.

use val3_syntax::xml::XmlElement;

/// Elements that declare data: in `<Datas>`, or in all sections of s5 and s6.
pub(crate) fn elements(root: XmlElement<'_>) -> impl Iterator<Item = XmlElement<'_>> {
    let is_new = root.name() == "Database";
    let lists = root.elements().filter(move |list| !is_new || list.name() == "Datas");
    lists.flat_map(XmlElement::elements).filter(move |element| !is_new || element.name() == "Data")
}
