//! Types, containers and their initial values.

use std::collections::BTreeMap;
use std::sync::Arc;

use val3_lang::memory::{
    ContainerShape, DetachedValue, FieldKind, KindBase, LinkPlace, Memory, PartInit, Place, ValueType,
};
use val3_lang::types::{Arm, BaseType, Container};
use val3_lang::values::Text;

use super::ListingForm;
use super::error::Result;
use super::forms::{InArm, Name, Number, Optional, sequences};
use super::operands::{self, FLANGE, WORLD};
use super::reader::ListingReader;
use super::writer::Writer;

/// A built-in type: `num`.
pub(super) struct BaseName;

impl ListingForm for BaseName {
    type Value = BaseType;

    fn write(value: &BaseType, to: &mut Writer<'_>) {
        to.put(value.name());
    }

    fn read(from: &mut ListingReader<'_>) -> Result<BaseType> {
        let name = from.take();
        BaseType::named(name).map_or_else(|| from.fail(&format!("`{name}` is no type")), Ok)
    }
}

/// An arm by its suffix in type names: `Rs`.
pub(super) struct ArmName;

impl ListingForm for ArmName {
    type Value = Arm;

    fn write(value: &Arm, to: &mut Writer<'_>) {
        to.put(value.suffix());
    }

    fn read(from: &mut ListingReader<'_>) -> Result<Arm> {
        let name = from.take();
        let arm = Arm::ALL.into_iter().find(|arm| arm.suffix() == name);
        arm.map_or_else(|| from.fail(&format!("`{name}` is no arm")), Ok)
    }
}

/// Any type: `num`, `@Slot`.
pub(super) struct ListedType;

impl ListingForm for ListedType {
    type Value = Arc<ValueType>;

    fn write(value: &Arc<ValueType>, to: &mut Writer<'_>) {
        if let KindBase::Builtin(base, arm) = value.base {
            return <(BaseName, Optional<InArm, ArmName>)>::write(&(base, arm), to);
        }
        let known = |to: &Writer<'_>| to.kinds.iter().position(|kind| Arc::ptr_eq(kind, value) || kind == value);
        let number = known(to).unwrap_or_else(|| declare(value, to));
        let kinds = to.kinds.clone();
        to.put("@");
        to.item(kinds.iter().map(|kind| user_name(kind)), number);
    }

    fn read(from: &mut ListingReader<'_>) -> Result<Arc<ValueType>> {
        if !from.accept("@") {
            let (base, arm) = <(BaseName, Optional<InArm, ArmName>)>::read(from)?;
            return Ok(Arc::new(ValueType::builtin(base, arm)));
        }
        let names = |from: &ListingReader<'_>| from.kinds.iter().map(|kind| user_name(kind).to_owned()).collect();
        let number = from.item("type", names)?;
        from.kinds.get(usize::from(number)).cloned().map_or_else(|| from.fail("there is no such type"), Ok)
    }
}

fn user_name(kind: &ValueType) -> &str {
    match &kind.base {
        KindBase::User(name) => name,
        KindBase::Builtin(base, _) => base.name(),
    }
}

/// Adds a user type to the declared types, after its fields' types.
fn declare(kind: &Arc<ValueType>, to: &mut Writer<'_>) -> usize {
    let declaration = to.aside(|to| {
        to.put("type ");
        to.name(user_name(kind));
        to.put(" {\n");
        for field in &kind.fields {
            to.put("    ");
            FieldKind::write(field, to);
            to.put("\n");
        }
        to.put("}\n");
    });
    to.types.push_str(&declaration);
    to.kinds.push(Arc::clone(kind));
    to.kinds.len() - 1
}

sequences! {
    FieldKind { name: Name, init: PartInit };
}

impl ListingReader<'_> {
    /// Reads the declaration of a user type after its first word.
    pub(super) fn user_type(&mut self) -> Result<()> {
        let name = self.name()?;
        self.expect("{")?;
        let fields = self.list("", "}", FieldKind::read)?;
        self.kinds.push(Arc::new(ValueType::user(name, fields)));
        Ok(())
    }
}

impl ListingForm for PartInit {
    type Value = Self;

    fn write(value: &Self, to: &mut Writer<'_>) {
        ListedType::write(&value.kind, to);
        to.put("[");
        match &value.shape {
            ContainerShape::Array { dims, sizes } => {
                to.list(sizes.iter().take((*dims).into()), ", ", Number::write);
            }
            ContainerShape::Collection(keys) => {
                let mut keys: Vec<(&u32, &Text)> = keys.iter().map(|(key, number)| (number, key)).collect();
                keys.sort_unstable();
                to.list(keys, ", ", |(_, key), to| to.quoted(key));
            }
        }
        to.put("]");
        if !value.values.is_empty() {
            to.put(" {");
            to.list(&value.values, ", ", |value, to| match value {
                Some(value) => DetachedValue::write(value, to),
                None => to.put("_"),
            });
            to.put("}");
        }
    }

    fn read(from: &mut ListingReader<'_>) -> Result<Self> {
        let kind = ListedType::read(from)?;
        from.expect("[")?;
        let shape = if matches!(from.peek().chars().next(), Some('"' | ']')) {
            let keys = from.list(",", "]", operands::text)?;
            let numbered = keys.iter().copied().zip(0..).collect::<BTreeMap<_, _>>();
            if numbered.len() < keys.len() {
                return from.fail("two of these keys are equal");
            }
            ContainerShape::Collection(numbered)
        } else {
            match *from.list(",", "]", ListingReader::number)? {
                [size] => ContainerShape::array(size),
                [rows, columns] => ContainerShape::Array { dims: 2, sizes: [rows, columns, 1] },
                [x, y, z] => ContainerShape::Array { dims: 3, sizes: [x, y, z] },
                _ => return from.fail("one to three sizes are expected here"),
            }
        };
        let values = if from.accept("{") {
            from.list(",", "}", |from| if from.accept("_") { Ok(None) } else { value(&kind, from).map(Some) })?
        } else {
            Vec::new()
        };
        Ok(Self { kind, shape, values })
    }
}

/// A value's lanes in parentheses: numbers, texts, links unless all are empty, and the fields' containers. A single
/// number or string has no parentheses.
impl ListingForm for DetachedValue {
    type Value = Self;

    fn write(value: &Self, to: &mut Writer<'_>) {
        let Self { nums, texts, links, parts } = value;
        match (nums.as_slice(), texts.as_slice(), links.is_empty() && parts.is_empty()) {
            ([num], [], true) => return to.put(&num.to_string()),
            ([], [text], true) => return to.quoted(text),
            _ => {}
        }
        let linked = if links.iter().all(|link| *link == LinkPlace::None) { &[] } else { links.as_slice() };
        let nums = nums.iter().map(f64::to_string);
        let texts = texts.iter().map(|text| to.aside(|to| to.quoted(text))).collect::<Vec<_>>();
        let links = linked.iter().map(|link| link_name(*link).to_owned());
        let parts = parts.iter().map(|part| to.aside(|to| PartInit::write(part, to))).collect::<Vec<_>>();
        let lanes: Vec<String> = nums.chain(texts).chain(links).chain(parts).collect();
        to.put(&format!("({})", lanes.join(" ")));
    }

    fn read(from: &mut ListingReader<'_>) -> Result<Self> {
        let is_single = !from.accept("(");
        let mut value = Self::default();
        loop {
            let token = from.peek();
            if let Ok(num) = token.parse() {
                from.take();
                value.nums.push(num);
            } else if token.starts_with('"') {
                value.texts.push(operands::text(from)?);
            } else if let Some(link) = LINKS.into_iter().find(|link| link_name(*link) == token) {
                from.take();
                value.links.push(link);
            } else if token != ")" {
                value.parts.push(PartInit::read(from)?);
            }
            if is_single || from.accept(")") {
                return Ok(value);
            }
        }
    }
}

/// Reads a value with this type, and checks the number of lanes.
fn value(kind: &ValueType, from: &mut ListingReader<'_>) -> Result<DetachedValue> {
    let mut value = DetachedValue::read(from)?;
    if value.links.is_empty() {
        value.links.resize(kind.size.link as usize, LinkPlace::None);
    }
    let lanes = [value.nums.len(), value.texts.len(), value.links.len(), value.parts.len()];
    let size = [kind.size.num, kind.size.text, kind.size.link, kind.size.part].map(|lanes| lanes as usize);
    if lanes == size {
        return Ok(value);
    }
    let [nums, texts, links, parts] = size;
    from.fail(&format!("a value of this type has {nums} numbers, {texts} texts, {links} links and {parts} containers"))
}

/// Links that values in files can have; all other links are set after the data are created.
const LINKS: [LinkPlace; 3] =
    [LinkPlace::None, LinkPlace::Data(Place::first(Memory::WORLD)), LinkPlace::Data(Place::first(Memory::FLANGE))];

fn link_name(link: LinkPlace) -> &'static str {
    let [none, world, flange] = LINKS;
    match link {
        link if link == none => "none",
        link if link == world => WORLD,
        link if link == flange => FLANGE,
        _ => "?",
    }
}

/// Container of a parameter or local, after its type: nothing, `[]`, `[,]`, `[""]`.
pub(super) struct Brackets;

impl ListingForm for Brackets {
    type Value = Container;

    fn write(value: &Container, to: &mut Writer<'_>) {
        match value {
            Container::Element => {}
            Container::Array { dims } => to.put(&format!("[{}]", ",".repeat(usize::from(*dims).saturating_sub(1)))),
            Container::Collection => to.put("[\"\"]"),
        }
    }

    fn read(from: &mut ListingReader<'_>) -> Result<Container> {
        if !from.accept("[") {
            return Ok(Container::Element);
        }
        let container = if from.accept("\"\"") {
            Container::Collection
        } else {
            let dims = 1 + (0..2).filter(|_| from.accept(",")).fold(0, |dims, _| dims + 1);
            Container::Array { dims }
        };
        from.expect("]").map(|()| container)
    }
}
