//! Values in a data file into which a mistake can be seeded.

use std::borrow::Cow;

use val3_data::{WrittenAttribute, WrittenVariable, number_text, written};
use val3_lang::enumerations::{find_in_file, values};
use val3_lang::types::{AttributeValue, BaseType};
use val3_syntax::{parse, xml};

use super::site::{Escapes, Site, line_at};

/// Distance added to a coordinate or joint, in mm or degrees.
const DISTANCE: f64 = 10.0;

/// Minimum speed without effect as a limit for any arm, in mm/s or degrees/s.
const UNLIMITED: f64 = 9999.0;

/// Largest number that is changed.
const LARGEST: f64 = 1e15;

/// Variable with the mistakes that can be seeded into its values.
#[derive(Debug)]
pub(super) struct DataSites {
    pub(super) name: String,
    pub(super) sites: Vec<Site>,
}

/// Finds the variables in a data file and their mistakes, in file order.
pub(super) fn data_sites(text: &str) -> Vec<DataSites> {
    let parse = parse(text);
    let variables = xml::root(parse.view()).map(written).unwrap_or_default();
    variables.into_iter().map(|variable| variable_sites(text, variable)).collect()
}

fn variable_sites(text: &str, WrittenVariable { name, attributes, .. }: WrittenVariable) -> DataSites {
    DataSites { name, sites: attributes.iter().filter_map(|attribute| site(text, attribute)).collect() }
}

fn site(text: &str, attribute: &WrittenAttribute<'_>) -> Option<Site> {
    let found = attribute.text.text();
    let range = usize::from(attribute.text.range.start())..usize::from(attribute.text.range.end());
    Some(Site {
        path: Some(attribute.path.clone()),
        line: line_at(text, range.start),
        replacement: replacement(attribute, &found)?.into_owned(),
        found: found.into_owned(),
        range,
        escapes: Escapes::Attribute,
    })
}

/// Another value of the same kind; `None` for links, fathers and invalid values.
fn replacement(attribute: &WrittenAttribute<'_>, found: &str) -> Option<Cow<'static, str>> {
    match attribute.meaning.value {
        AttributeValue::Truth => match found.trim() {
            "true" => Some("false".into()),
            "false" => Some("true".into()),
            _ => None,
        },
        AttributeValue::Number => {
            let number = found.trim().parse().ok().filter(|number: &f64| number.abs() < LARGEST)?;
            match attribute.base {
                BaseType::Num => Some(number_text(number + 1.0).into()),
                // Greater values are no limit, so halving them would have no effect.
                BaseType::Mdesc => (number < UNLIMITED).then(|| number_text(number / 2.0).into()),
                _ => Some(number_text(number + DISTANCE).into()),
            }
        }
        AttributeValue::Text => Some(format!("{found}x").into()),
        AttributeValue::Choice(ty) => {
            let present = find_in_file(ty, found.trim())?;
            let mut others = values(ty).filter(|other| other.name != present.name);
            // The last value of a configuration is the opposite of the value before it. The first values have little
            // effect.
            let other = if ty == BaseType::Blend { others.next() } else { others.last() };
            other.map(|other| other.file_name.into())
        }
        AttributeValue::Link | AttributeValue::Father(_) => None,
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    const DATA: &str = r#"<?xml version="1.0" encoding="utf-8"?>
<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
  <Datas>
    <Data name="nCount" access="private" xsi:type="array" type="num" size="2"><Value key="1" value="1e3" /></Data>
    <Data name="nEmpty" access="private" xsi:type="array" type="num" size="1" />
    <Data name="bRun" access="private" xsi:type="array" type="bool" size="1"><Value key="0" value="true" /></Data>
    <Data name="sText" access="private" xsi:type="collection" type="string">
      <Value key="a" value="" />
      <Value key="b" value="&lt;b&gt;" />
    </Data>
    <Data name="mFast" access="private" xsi:type="array" type="mdesc" size="1">
      <Value key="0" vel="90" tvel="99999" blend="joint" leave="50" />
    </Data>
    <Data name="pPick" access="private" xsi:type="array" type="pointRx" size="1">
      <Value key="0" x="-0.5" wrist="wpositive" fatherId="fTray[0]" />
    </Data>
    <Data name="diGo" access="private" xsi:type="array" type="dio" size="1"><Value key="0" link="Io\%I0" /></Data>
    <Data name="tSlot" access="private" xsi:type="array" type="Slot" size="1">
      <Value key="0">
        <Field name="nKind" xsi:type="array" type="num" size="1"><Value key="0" value="2" /></Field>
      </Value>
    </Data>
  </Datas>
</Database>
"#;

    #[test]
    fn each_kind_of_value_gets_a_mistake() {
        let lines = data_sites(DATA).into_iter().flat_map(|variable| variable.sites);
        let shown: String = lines.map(|site| format!("{}: {}\n", site.line, site.change())).collect();
        expect![[r#"
            4: nCount[1]: `1e3` becomes `1001`
            6: bRun: `true` becomes `false`
            8: sText["a"]: `` becomes `x`
            9: sText["b"]: `<b>` becomes `<b>x`
            12: mFast.vel: `90` becomes `45`
            12: mFast.blend: `joint` becomes `off`
            12: mFast.leave: `50` becomes `25`
            15: pPick.trsf.x: `-0.5` becomes `9.5`
            15: pPick.config.wrist: `wpositive` becomes `wnegative`
            20: tSlot.nKind: `2` becomes `3`
        "#]]
        .assert_eq(&shown);
    }

    #[test]
    fn a_mistake_changes_its_line_alone() {
        for site in data_sites(DATA).into_iter().flat_map(|variable| variable.sites) {
            let mutant = site.applied(DATA);
            assert!(parse(&mutant).errors().is_empty(), "{}", site.change());
            let pairs = DATA.lines().zip(mutant.lines());
            let changed: Vec<usize> = (1..).zip(pairs).filter(|(_, (a, b))| a != b).map(|(line, _)| line).collect();
            assert_eq!(changed, [site.line as usize], "{}", site.change());
        }
    }

    #[test]
    fn files_without_data_get_no_mistakes() {
        assert!(data_sites("no XML").is_empty());
    }

    #[test]
    fn the_old_dialect_gets_the_same_mistakes() {
        let text = r#"<?xml version="1.0" encoding="iso-8859-1"?>
<dataList xmlns="DataNameSpace">
  <pointSection><point name="pPick" public="false"><valuePoint index="0"><ptPosition x="1" y="2" z="3" />
    <configRX shoulder="lefty" elbow="esame" wrist="wsame" /></valuePoint></point></pointSection>
</dataList>"#;
        let sites = data_sites(text).into_iter().flat_map(|variable| variable.sites);
        let changes: Vec<String> = sites.map(|site| site.change()).collect();
        assert_eq!(changes.first().map(String::as_str), Some("pPick.trsf.x: `1` becomes `11`"));
        assert!(changes.contains(&"pPick.config.shoulder: `lefty` becomes `righty`".to_owned()), "{changes:?}");
    }
}
