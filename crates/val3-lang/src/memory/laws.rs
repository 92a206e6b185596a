//! Laws of references: whatever happens to a container, a reference denotes the same element, or none.

use std::collections::BTreeMap;
use std::sync::Arc;

use proptest::prelude::{Just, Strategy, TestCaseError, prop_assert_eq, prop_oneof, proptest};

use super::{ContainerShape, FieldKind, LinkPlace, Memory, PartInit, Place, Slot, StoreId, Subscript, ValueType, View};
use crate::fault::{Fault, Result};
use crate::types::BaseType;
use crate::values::Text;

fn init(kind: ValueType, shape: ContainerShape) -> PartInit {
    PartInit { kind: Arc::new(kind), shape, values: Vec::new() }
}

fn field(name: &str, init: PartInit) -> FieldKind {
    FieldKind { name: name.to_owned(), init }
}

fn user(fields: Vec<FieldKind>) -> ValueType {
    ValueType::user("T".to_owned(), fields)
}

/// Checks that each container's memory is counted once.
fn check_room(memory: &Memory, data: &[StoreId]) -> std::result::Result<(), TestCaseError> {
    let known = [Memory::WORLD, Memory::FLANGE];
    let bytes: u64 = known.iter().chain(data).map(|id| memory.bytes(*id)).sum();
    prop_assert_eq!(memory.stores.room.taken(), bytes);
    Ok(())
}

#[derive(Debug, Clone)]
enum GridAction {
    Resize(u8, u8),
    Refer([u8; 3]),
    Write(usize, f64),
}

fn grid_action() -> impl Strategy<Value = GridAction> {
    prop_oneof![
        (1..4u8, 1..4u8).prop_map(|(dimension, size)| GridAction::Resize(dimension, size)),
        [0..3u8, 0..3u8, 0..3u8].prop_map(GridAction::Refer),
        (0..9usize, 1..99u32).prop_map(|(reference, value)| GridAction::Write(reference, value.into())),
    ]
}

#[derive(Debug, Clone)]
enum TypeAction {
    Insert(bool, char),
    Delete(bool, char),
    Append(bool),
    Refer(bool, char),
    ReferToRow(bool, u8),
    Copy,
}

fn type_action() -> impl Strategy<Value = TypeAction> {
    let side = || prop_oneof![Just(false), Just(true)];
    let key = || proptest::char::range('a', 'd');
    prop_oneof![
        3 => (side(), key()).prop_map(|(side, key)| TypeAction::Insert(side, key)),
        3 => (side(), key()).prop_map(|(side, key)| TypeAction::Delete(side, key)),
        1 => side().prop_map(TypeAction::Append),
        3 => (side(), key()).prop_map(|(side, key)| TypeAction::Refer(side, key)),
        1 => (side(), 0..3u8).prop_map(|(side, row)| TypeAction::ReferToRow(side, row)),
        1 => Just(TypeAction::Copy),
    ]
}

/// Two variables of a user type whose fields are a collection and an array of a user type, and a collection of frames.
struct Pair {
    memory: Memory,
    kind: Arc<ValueType>,
    stores: [StoreId; 2],
    /// Life of each key, by variable.
    lives: [BTreeMap<char, u32>; 2],
    begun: u32,
}

/// An element by its key, with the life of the key.
struct KeyReference {
    side: bool,
    key: char,
    life: u32,
    /// Address of a field in the element, and of the frame with the same key.
    places: [Place; 2],
}

impl Pair {
    fn new() -> Self {
        let inner = || user(vec![field("nV", init(ValueType::builtin(BaseType::Num, None), ContainerShape::array(2)))]);
        let keys = || ContainerShape::Collection(BTreeMap::new());
        let fields = vec![
            field("tKeyed", init(inner(), keys())),
            field("fKeyed", init(ValueType::builtin(BaseType::Frame, None), keys())),
            field("tRow", init(inner(), ContainerShape::array(1))),
        ];
        let mut memory = Memory::new();
        let kind = Arc::new(user(fields));
        let data = PartInit { kind: Arc::clone(&kind), shape: ContainerShape::ELEMENT, values: Vec::new() };
        let stores = [0; 2].map(|_| memory.create(&data).unwrap());
        Self { memory, kind, stores, lives: Default::default(), begun: 0 }
    }

    fn field(&self, side: bool, field: u32) -> StoreId {
        self.memory.part(Place::first(self.stores[usize::from(side)]), field).unwrap()
    }

    fn keyed(&self, side: bool, key: char) -> Result<[Place; 2]> {
        let element = self.element(side, 0, key)?;
        let inner = self.memory.element(View::whole(self.memory.part(element, 0)?), 1)?;
        Ok([inner, self.element(side, 1, key)?])
    }

    fn element(&self, side: bool, field: u32, key: char) -> Result<Place> {
        let id = self.field(side, field);
        let store = self.memory.store(id)?;
        Ok(store.place(id, store.number_of(&Text::from(key.to_string().as_str()))?))
    }

    fn row(&self, side: bool, row: u8) -> Result<Place> {
        let element = self.memory.element(View::whole(self.field(side, 2)), row.into())?;
        self.memory.element(View::whole(self.memory.part(element, 0)?), 1)
    }

    fn begin(&mut self, side: bool, key: char) {
        self.begun += 1;
        self.lives[usize::from(side)].insert(key, self.begun);
    }

    /// Executes an action that changes containers.
    fn change(&mut self, action: &TypeAction) {
        let text = |key: char| Text::from(key.to_string().as_str());
        match *action {
            TypeAction::Insert(side, key) => {
                for field in 0..2 {
                    self.memory.insert_key(self.field(side, field), text(key), None).unwrap();
                }
                if !self.lives[usize::from(side)].contains_key(&key) {
                    self.begin(side, key);
                }
            }
            TypeAction::Delete(side, key) => {
                let existed = self.lives[usize::from(side)].remove(&key).is_some();
                for field in 0..2 {
                    assert_eq!(self.memory.delete_key(self.field(side, field), &text(key)).is_ok(), existed);
                }
            }
            TypeAction::Append(side) => self.memory.append(self.field(side, 2), None).unwrap(),
            TypeAction::Copy => {
                let [from, to] = self.stores.map(Place::first);
                let kind = Arc::clone(&self.kind);
                self.memory.copy(&kind, from, to).unwrap();
                let [source, target] = self.lives.clone();
                self.lives[1].retain(|key, _| source.contains_key(key));
                source.keys().filter(|key| !target.contains_key(key)).for_each(|key| self.begin(true, *key));
                assert_eq!(self.memory.equal(&kind, from, to), Ok(true));
            }
            TypeAction::Refer(..) | TypeAction::ReferToRow(..) => {}
        }
    }
}

proptest! {
    #[test]
    fn references_to_grids_keep_their_indexes(actions in proptest::collection::vec(grid_action(), 1..40)) {
        let mut memory = Memory::new();
        let grid = ContainerShape::Array { dims: 3, sizes: [2, 2, 2] };
        let id = memory.create(&init(ValueType::builtin(BaseType::Frame, None), grid)).unwrap();
        let points = init(ValueType::builtin(BaseType::Point, None), ContainerShape::array(99));
        let points = memory.create(&points).unwrap();
        let mut references: Vec<([f64; 3], Place)> = Vec::new();
        for action in actions {
            match action {
                GridAction::Resize(dimension, size) => {
                    memory.resize(View::whole(id), dimension.into(), size.into(), None).unwrap();
                }
                GridAction::Refer(at) => {
                    let indexes = at.map(f64::from);
                    let slot = Slot { view: Some(View::whole(id)), at: Subscript::Three(indexes) };
                    if let Ok(place) = memory.locate(&slot) {
                        let point = memory.element(View::whole(points), references.len() as u32).unwrap();
                        memory.set_link(point, 0, LinkPlace::Data(place)).unwrap();
                        references.push((indexes, place));
                    }
                }
                GridAction::Write(reference, value) => {
                    if let Some((_, place)) = references.get(reference) {
                        let _ = memory.set_num(*place, 3, value);
                    }
                }
            }
            for (number, (indexes, place)) in (0..).zip(&references) {
                let slot = Slot { view: Some(View::whole(id)), at: Subscript::Three(*indexes) };
                let element = memory.locate(&slot);
                let expected = element.and_then(|element| memory.nums::<6>(element, 0));
                prop_assert_eq!(memory.nums::<6>(*place, 0), expected);
                if element.is_ok() {
                    prop_assert_eq!(memory.present(*place), element);
                }
                let point = memory.element(View::whole(points), number).unwrap();
                let LinkPlace::Data(father) = memory.link(point, 0).unwrap() else { panic!("no father") };
                prop_assert_eq!(memory.num(father, 3), expected.map(|nums| nums[3]));
            }
            check_room(&memory, &[id, points])?;
        }
    }

    #[test]
    fn references_end_with_their_keys(actions in proptest::collection::vec(type_action(), 1..40)) {
        let mut pair = Pair::new();
        let (mut keys, mut rows) = (Vec::new(), Vec::new());
        for action in actions {
            pair.change(&action);
            match action {
                TypeAction::Refer(side, key) => {
                    if let Some(life) = pair.lives[usize::from(side)].get(&key).copied() {
                        let places = pair.keyed(side, key).unwrap();
                        keys.push(KeyReference { side, key, life, places });
                    }
                }
                TypeAction::ReferToRow(side, row) => {
                    rows.extend(pair.row(side, row).map(|place| (side, row, place)));
                }
                _ => {}
            }
            for KeyReference { side, key, life, places } in &keys {
                let lives = pair.lives[usize::from(*side)].get(key) == Some(life);
                let expected = if lives { pair.keyed(*side, *key).map(Some) } else { Ok(None) }.unwrap();
                for (at, place) in places.iter().enumerate() {
                    let expected = expected.map_or(Err(Fault::INDEX_TOO_LARGE), |places| Ok(places[at]));
                    prop_assert_eq!(pair.memory.present(*place), expected);
                    let value = f64::from(*life) + 0.5;
                    prop_assert_eq!(pair.memory.set_num(*place, 0, value), expected.map(|_| ()));
                }
            }
            for (side, row, place) in &rows {
                prop_assert_eq!(pair.memory.present(*place), pair.row(*side, *row));
            }
            // The fields of a new row are other data than the fields of the removed row with the same index.
            rows.retain(|(side, row, _)| pair.row(*side, *row).is_ok());
            check_room(&pair.memory, &pair.stores)?;
        }
    }
}
