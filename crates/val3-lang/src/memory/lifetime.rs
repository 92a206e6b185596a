//! Whose data are, and what may refer to them (errors 82 and 165).

use super::{Link, Memory, StoreId};
use crate::fault::{Fault, Result};
use crate::runtime_errors::{GLOBAL_REFERS_TO_LOCAL, REFERENCE_OUT_OF_REACH};

/// Whose values are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scope {
    /// The controller's: everything may refer to them.
    Everywhere,
    /// A program's, with which they end.
    Program,
    /// Global data.
    Data(Owner),
}

/// The application or library that global data belong to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Owner {
    /// Its number in memory; 0 is the application.
    pub number: u16,
    /// Others see the data.
    pub public: bool,
}

impl Memory {
    /// The values of a container end with a program.
    #[must_use]
    pub fn is_local(&self, id: StoreId) -> bool {
        self.scope(id).is_ok_and(|scope| scope == Scope::Program)
    }

    /// Whose the values of a container are.
    ///
    /// # Errors
    /// 61 if it is gone.
    pub fn scope(&self, id: StoreId) -> Result<Scope> {
        if id == StoreId::STACK { Ok(Scope::Program) } else { self.store(id).map(|store| store.scope) }
    }

    /// What a value in a `scope` may be linked to. A local one may be linked to everything.
    ///
    /// # Errors
    /// 165 if it would outlive what it refers to, 82 if that belongs to a library and cannot be named where the value is
    /// declared: it is private there, or the library is not declared here.
    pub(super) fn check_link(&self, scope: Scope, link: Link) -> Result<()> {
        let Link::Data(reference) = link else { return Ok(()) };
        if scope == Scope::Program {
            return Ok(());
        }
        // What refers to something gone has no reference; it can be copied.
        match (scope, self.scope(reference.store).unwrap_or(Scope::Everywhere)) {
            (_, Scope::Program) => Err(Fault(GLOBAL_REFERS_TO_LOCAL)),
            (Scope::Data(own), Scope::Data(other)) if !self.sees(own, other) => Err(Fault(REFERENCE_OUT_OF_REACH)),
            _ => Ok(()),
        }
    }

    fn sees(&self, own: Owner, other: Owner) -> bool {
        let is_of_library = own.number != other.number && other.number != Owner::default().number;
        !is_of_library || (other.public && self.seen.contains(&(own.number, other.number)))
    }

    /// Takes from the links below `end` on the stack those that lead to what ends there with a program: it was called
    /// with a variable by reference and has hung it on a local one.
    #[inline]
    pub fn cut_links(&mut self, end: u32) {
        if self.stack.links.len() > end as usize {
            let ends = |link: &&mut Link| matches!(link, Link::Data(place) if place.store == StoreId::STACK && place.link >= end);
            self.stack.links.iter_mut().take(end as usize).filter(ends).for_each(|link| *link = Link::None);
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::{Fault, Link, Memory, Owner};
    use crate::memory::{FieldKind, Kind, PartInit, Place, Shape, View};
    use crate::types::BaseType;

    fn init(kind: Kind, shape: Shape) -> PartInit {
        PartInit { kind: Arc::new(kind), shape, values: Vec::new() }
    }

    /// A user type with one field: a row of two frames.
    fn station() -> PartInit {
        let row = init(Kind::builtin(BaseType::Frame, None), Shape::array(2));
        init(Kind::user("Station".to_owned(), vec![FieldKind { name: "row".to_owned(), init: row }]), Shape::ELEMENT)
    }

    #[test]
    fn a_field_ends_with_its_variable() {
        let mut memory = Memory::new();
        let (global, local) = (memory.create(&station(), Owner::default()), memory.create_local(&station()));
        let first = |memory: &Memory, store| Place::first(memory.part(Place::first(store), 0).unwrap());
        let (global, local) = (first(&memory, global), first(&memory, local));
        assert_eq!(memory.set_link(global, 0, Link::Data(local)), Err(Fault(165)));
        assert_eq!(memory.set_link(local, 0, Link::Data(global)), Ok(()));
        assert_eq!(memory.set_link(local, 0, Link::Data(local)), Ok(()));
    }

    #[test]
    fn fields_of_a_local_variable_grow_and_stay_local() {
        let mut memory = Memory::new();
        let (local, global) = (memory.create_local(&station()), memory.create(&station(), Owner::default()));
        let row = memory.part(Place::first(local), 0).unwrap();
        assert_eq!(memory.append(row, None), Ok(()));
        assert_eq!(memory.append(local, None), Err(Fault::INVALID_PARAMETER));
        let grown = memory.element(View::whole(row), 2).unwrap();
        let other = Place::first(memory.part(Place::first(global), 0).unwrap());
        assert_eq!(memory.set_link(other, 0, Link::Data(grown)), Err(Fault(165)));
    }

    #[test]
    fn a_copy_lasts_as_long_as_what_it_is_in() {
        let mut memory = Memory::new();
        let stations = PartInit { shape: Shape::array(2), ..station() };
        let kind = Kind::user("Line".to_owned(), vec![FieldKind { name: "all".to_owned(), init: stations }]);
        let line = init(kind.clone(), Shape::ELEMENT);
        let (global, local) =
            (Place::first(memory.create(&line, Owner::default())), Place::first(memory.create_local(&line)));
        memory.copy(&kind, global, local).unwrap();
        let copied = memory.part(Place::first(memory.part(local, 0).unwrap()), 0).unwrap();
        assert!(memory.is_local(copied));
        memory.set_link(Place::first(copied), 0, Link::Data(Place::first(copied))).unwrap();
        assert_eq!(memory.copy(&kind, local, global), Err(Fault(165)));
    }
}
