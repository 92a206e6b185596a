//! Checks whether data may refer to other data (errors 82 and 165).

use super::{LinkPlace, Memory, Owner, Place, StoreId};
use crate::fault::{Fault, Result};
use crate::runtime_errors::{GLOBAL_REFERS_TO_LOCAL, REFERENCE_OUT_OF_REACH};

impl Memory {
    /// Owner of a container.
    #[inline]
    pub(super) fn owner(&self, id: StoreId) -> Owner {
        match id {
            StoreId::STACK => Owner::Program,
            id => self.store(id).map_or(Owner::Controller, |store| store.owner),
        }
    }

    /// Whether the container is removed at the end of a program.
    #[must_use]
    pub fn is_local(&self, id: StoreId) -> bool {
        self.owner(id) == Owner::Program
    }

    /// Application or library to which global data belong, including their fields.
    #[must_use]
    pub fn project(&self, id: StoreId) -> Option<u16> {
        match self.owner(id) {
            Owner::Project { number, .. } => Some(number),
            Owner::Controller | Owner::Program => None,
        }
    }

    /// Sets the current libraries for the identifiers that an application or library declares, by number.
    pub fn declare_libraries(&mut self, project: u16, libraries: Vec<u16>) {
        let at = usize::from(project);
        if self.libraries.len() <= at {
            self.libraries.resize(at + 1, Vec::new());
        }
        if let Some(known) = self.libraries.get_mut(at) {
            *known = libraries;
        }
    }

    /// Checks that a value may have a linked frame or tool as its father.
    ///
    /// # Errors
    /// 82 if it must not refer to it.
    #[inline]
    pub fn check_reference(&self, at: Place, reference: Place) -> Result<()> {
        self.check_link(self.owner(at.store), LinkPlace::Data(reference))
    }

    /// Checks that an owner's value may have this link.
    ///
    /// # Errors
    /// 165 if the value would outlive the target. 82 if the target belongs to a library that the owner does not
    /// declare, or is private in that library.
    #[inline]
    pub(super) fn check_link(&self, owner: Owner, link: LinkPlace) -> Result<()> {
        let LinkPlace::Data(reference) = link else { return Ok(()) };
        match (owner, self.owner(reference.store)) {
            (Owner::Program, _) => Ok(()),
            (_, Owner::Program) => Err(Fault(GLOBAL_REFERS_TO_LOCAL)),
            (Owner::Project { number: user, .. }, Owner::Project { number: library, public })
                if !self.reaches(user, library, public) =>
            {
                Err(Fault(REFERENCE_OUT_OF_REACH))
            }
            _ => Ok(()),
        }
    }

    /// Removes the links below `end` on the stack that refer to data above `end`, which are removed at the end of a
    /// program. Such links exist if the program was called with a variable by reference and has linked it to a local
    /// variable.
    #[inline]
    pub fn cut_links(&mut self, end: u32) {
        if self.stack.links.len() > end as usize {
            let ends = |place: &Place| place.store == StoreId::STACK && place.link >= end;
            let kept = self.stack.links.iter_mut().take(end as usize);
            let dangling = kept.filter(|link| matches!(link, LinkPlace::Data(place) if ends(place)));
            dangling.for_each(|link| *link = LinkPlace::None);
        }
    }

    /// Whether data may refer to a library. All data may refer to the application, because it is never unloaded.
    fn reaches(&self, user: u16, library: u16, public: bool) -> bool {
        let declared = || self.libraries.get(usize::from(user)).is_some_and(|libraries| libraries.contains(&library));
        library == 0 || library == user || public && declared()
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::{Fault, LinkPlace, Memory, Owner};
    use crate::memory::{ContainerShape, FieldKind, PartInit, Place, ValueType, View};
    use crate::types::BaseType;

    fn init(kind: ValueType, shape: ContainerShape) -> PartInit {
        PartInit { kind: Arc::new(kind), shape, values: Vec::new() }
    }

    /// User type with one field: an array of two frames.
    fn station() -> PartInit {
        let row = init(ValueType::builtin(BaseType::Frame, None), ContainerShape::array(2));
        init(
            ValueType::user("Station".to_owned(), vec![FieldKind { name: "row".to_owned(), init: row }]),
            ContainerShape::ELEMENT,
        )
    }

    #[test]
    fn references_to_libraries() {
        let mut memory = Memory::new();
        let frame = init(ValueType::builtin(BaseType::Frame, None), ContainerShape::ELEMENT);
        let mut create = |owner| Place::first(memory.create_for(owner, &frame).unwrap());
        let of = |number, public| Owner::Project { number, public };
        let own = create(Owner::APPLICATION);
        let (public, private, user) = (create(of(1, true)), create(of(1, false)), create(of(2, true)));
        let local = create(Owner::Program);
        memory.declare_libraries(2, vec![1]);
        for (from, to, expected) in [
            (user, public, Ok(())),
            (user, private, Err(Fault(82))),
            (private, public, Ok(())),
            (public, private, Ok(())),
            (public, user, Err(Fault(82))),
            (own, public, Err(Fault(82))),
            (public, own, Ok(())),
            (local, private, Ok(())),
            (own, Place::first(Memory::WORLD), Ok(())),
        ] {
            assert_eq!(memory.set_link(from, 0, LinkPlace::Data(to)), expected, "{from:?} {to:?}");
        }
        memory.declare_libraries(2, Vec::new());
        assert_eq!(memory.check_reference(user, public), Err(Fault(82)));
    }

    #[test]
    fn a_field_ends_with_its_variable() {
        let mut memory = Memory::new();
        let (global, local) = (memory.create(&station()).unwrap(), memory.create_local(&station()).unwrap());
        let first = |memory: &Memory, store| Place::first(memory.part(Place::first(store), 0).unwrap());
        let (global, local) = (first(&memory, global), first(&memory, local));
        assert_eq!(memory.set_link(global, 0, LinkPlace::Data(local)), Err(Fault(165)));
        assert_eq!(memory.set_link(local, 0, LinkPlace::Data(global)), Ok(()));
        assert_eq!(memory.set_link(local, 0, LinkPlace::Data(local)), Ok(()));
    }

    #[test]
    fn fields_of_a_local_variable_grow_and_stay_local() {
        let mut memory = Memory::new();
        let (local, global) = (memory.create_local(&station()).unwrap(), memory.create(&station()).unwrap());
        let row = memory.part(Place::first(local), 0).unwrap();
        assert_eq!(memory.append(row, None), Ok(()));
        assert_eq!(memory.append(local, None), Err(Fault::INVALID_PARAMETER));
        let grown = memory.element(View::whole(row), 2).unwrap();
        let other = Place::first(memory.part(Place::first(global), 0).unwrap());
        assert_eq!(memory.set_link(other, 0, LinkPlace::Data(grown)), Err(Fault(165)));
    }

    #[test]
    fn a_copy_lives_as_long_as_its_container() {
        let mut memory = Memory::new();
        let stations = PartInit { shape: ContainerShape::array(2), ..station() };
        let kind = ValueType::user("Line".to_owned(), vec![FieldKind { name: "all".to_owned(), init: stations }]);
        let line = init(kind.clone(), ContainerShape::ELEMENT);
        let (global, local) =
            (Place::first(memory.create(&line).unwrap()), Place::first(memory.create_local(&line).unwrap()));
        memory.copy(&kind, global, local).unwrap();
        let copied = memory.part(Place::first(memory.part(local, 0).unwrap()), 0).unwrap();
        assert!(memory.is_local(copied));
        memory.set_link(Place::first(copied), 0, LinkPlace::Data(Place::first(copied))).unwrap();
        assert_eq!(memory.copy(&kind, local, global), Err(Fault(165)));
    }
}
