//! Written values of a data file with their data paths and their ranges.

use val3_lang::data_path::DataPath;
use val3_lang::types::{BaseType, ValueAttribute as TypeAttribute, attribute};
use val3_syntax::xml::{self, XmlElement};

use crate::layout::elements;
use crate::{SavedContainer, lists, read, type_name};

/// Nesting limit of fields within fields.
const NESTING: usize = 8;

/// A variable with the values that its file has.
#[derive(Debug)]
pub struct WrittenVariable<'g> {
    /// Name.
    pub name: String,
    /// Fathers of the values, without indexes: `fTray`, `lib:fTray`.
    pub fathers: Vec<String>,
    /// Written attributes, in the order of the file, without fathers.
    pub attributes: Vec<WrittenAttribute<'g>>,
}

/// A written attribute of a value.
#[derive(Debug)]
pub struct WrittenAttribute<'g> {
    /// Data path: `pPick.trsf.z`, `sSlots[1].nCount`, `dIn["door"]`.
    pub path: String,
    /// Type of the variable or field.
    pub base: BaseType,
    /// Meaning of the attribute.
    pub meaning: &'static TypeAttribute,
    /// Attribute in the file.
    pub text: xml::Attribute<'g>,
}

/// Returns the variables of a data file of either dialect with this root.
#[must_use]
pub fn written(root: XmlElement<'_>) -> Vec<WrittenVariable<'_>> {
    elements(root).map(variable).collect()
}

fn variable(element: XmlElement<'_>) -> WrittenVariable<'_> {
    let name = element.value("name").unwrap_or_default().into_owned();
    let mut variable = WrittenVariable { name: name.clone(), fathers: Vec::new(), attributes: Vec::new() };
    variable.fathers.extend(lists::father(element));
    variable.add(&name, element, NESTING);
    variable
}

impl<'g> WrittenVariable<'g> {
    /// Adds the values of a variable or field with this path.
    fn add(&mut self, path: &str, element: XmlElement<'g>, nesting: usize) {
        let shape = read(element).shape;
        let ty = BaseType::from_file_name(&type_name(element));
        for value in element.elements() {
            let Some(key) = value.value("key").or_else(|| value.value("index")) else { continue };
            let path = format!("{path}{}", subscript(&shape, &key));
            match ty {
                Some((base, _)) => self.add_value(&path, base, element, value),
                None if nesting > 0 => self.add_fields(&path, value, nesting - 1),
                None => {}
            }
        }
    }

    fn add_fields(&mut self, path: &str, value: XmlElement<'g>, nesting: usize) {
        for field in value.elements().filter(|field| field.name() == "Field") {
            let name = field.value("name").unwrap_or_default();
            self.add(&format!("{path}.{name}"), field, nesting);
        }
    }

    fn add_value(&mut self, path: &str, base: BaseType, element: XmlElement<'g>, value: XmlElement<'g>) {
        let arm = BaseType::from_file_name(&type_name(element)).and_then(|(_, arm)| arm);
        for text in lists::leaves(value) {
            let meaning = lists::name_of(text).and_then(|name| attribute(base, arm, name));
            match meaning {
                Some(meaning) if meaning.name == "fatherId" => self.fathers.extend(without_index(&text.text())),
                Some(meaning) => {
                    let path = match meaning.field {
                        "" => path.to_owned(),
                        field => format!("{path}.{field}"),
                    };
                    self.attributes.push(WrittenAttribute { path, base, meaning, text });
                }
                None => {}
            }
        }
    }
}

/// Index or key in a path. A single value has none.
fn subscript(shape: &SavedContainer, key: &str) -> String {
    match shape {
        SavedContainer::Keys => format!("[\"{key}\"]"),
        SavedContainer::Sizes(sizes) if sizes.iter().all(|size| *size == 1) => String::new(),
        SavedContainer::Sizes(_) => format!("[{key}]"),
    }
}

fn without_index(father: &str) -> Option<String> {
    let path = DataPath::new(father).before_index();
    (!path.is_empty()).then(|| path.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(text: &str) -> Vec<String> {
        let parse = val3_syntax::parse(text);
        let variables = written(xml::root(parse.view()).unwrap());
        variables.iter().map(line).collect()
    }

    fn line(variable: &WrittenVariable<'_>) -> String {
        let attributes = variable.attributes.iter();
        let values = attributes.map(|attribute| format!("{}={}", attribute.path, attribute.text.text()));
        let values: Vec<String> = values.collect();
        format!("{} in {}: {}", variable.name, variable.fathers.join(" "), values.join(" "))
    }

    #[test]
    fn values_have_data_paths() {
        let text = r#"<?xml version="1.0" encoding="utf-8"?>
<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
  <Datas>
    <Data name="pPick" access="private" xsi:type="array" type="pointRx" size="1">
      <Value key="0" x="1e3" wrist="wpositive" fatherId="lib:fTray[0]" />
    </Data>
    <Data name="jHome" access="private" xsi:type="array" type="jointRx" size="2"><Value key="1" j2="-20" /></Data>
    <Data name="sText" access="private" xsi:type="collection" type="string"><Value key="de" value="" /></Data>
    <Data name="tSlot" access="private" xsi:type="array" type="Slot" size="2">
      <Value key="1">
        <Field name="nCount" xsi:type="array" type="num" size="1"><Value key="0" value="3" /></Field>
      </Value>
    </Data>
  </Datas>
</Database>"#;
        assert_eq!(
            shown(text),
            [
                "pPick in lib:fTray: pPick.trsf.x=1e3 pPick.config.wrist=wpositive",
                "jHome in : jHome[1].j2=-20",
                "sText in : sText[\"de\"]=",
                "tSlot in : tSlot[1].nCount=3",
            ]
        );
    }

    #[test]
    fn lists_of_the_old_dialect_have_the_same_paths() {
        let text = r#"<?xml version="1.0" encoding="iso-8859-1"?>
<dataList xmlns="DataNameSpace">
  <numSection><num name="nCount" public="false" size="2">
    <valueNum index="0" value="3" /><valueNum index="1" value="4" />
  </num></numSection>
  <pointSection><point name="pPick" public="false">
    <pFather alias="" name="fTray" fatherIndex="0" />
    <valuePoint index="0"><ptPosition x="1" y="2" z="3" /><configRX shoulder="ssame" elbow="esame" wrist="wsame" /></valuePoint>
  </point></pointSection>
</dataList>"#;
        assert_eq!(
            shown(text),
            [
                "nCount in : nCount[0]=3 nCount[1]=4",
                "pPick in fTray: pPick.trsf.x=1 pPick.trsf.y=2 pPick.trsf.z=3 pPick.config.shoulder=ssame \
                 pPick.config.elbow=esame pPick.config.wrist=wsame",
            ]
        );
    }
}
