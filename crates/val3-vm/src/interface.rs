//! Items that an application expects from a library, and items that a library contains (6.3, 6.6).

use val3_bytecode::{DataDef, Image, Import, ImportKind, ProgramParam, Storage};
use val3_lang::memory::{ContainerShape, KindBase, ValueType};
use val3_lang::types::Container;

use crate::instance::Imported;
use crate::{Instance, InstanceId, ProgramId};

impl Instance {
    /// Returns this library's item for `import`, which `user` imports; `None` if the library has no such item, or if
    /// its item with this name has another type.
    pub(crate) fn item(&self, id: InstanceId, import: &Import, user: &Image) -> Option<Imported> {
        match &import.kind {
            ImportKind::Missing => return None,
            ImportKind::Data(kind, container) => {
                let number = usize::from(self.image.data(&import.name)?);
                self.image.data.get(number).filter(|data| is_data(data, kind, *container))?;
            }
            ImportKind::Program(params) => {
                let number = usize::from(self.image.program(&import.name)?);
                let own = &self.image.programs.get(number)?.params;
                let suits = own.len() == params.len()
                    && own
                        .iter()
                        .zip(params)
                        .all(|(own, (kind, container, by_reference))| is_param(own, kind, *container, *by_reference));
                if !suits {
                    return None;
                }
            }
        }
        self.find(id, &import.name, matches!(import.kind, ImportKind::Program(_)), user.sees_private_items)
    }

    /// Returns the library's public item `name`.
    pub(crate) fn export(&self, id: InstanceId, name: &str, of_program: bool) -> Option<Imported> {
        self.find(id, name, of_program, false)
    }

    /// Returns the item `name`, which has to be public unless private items count too.
    fn find(&self, id: InstanceId, name: &str, of_program: bool, private_too: bool) -> Option<Imported> {
        if of_program {
            let number = self.image.program(name)?;
            let program = self.image.programs.get(usize::from(number)).filter(|program| program.public || private_too);
            return program.map(|_| Imported::Program(ProgramId { instance: id, number }));
        }
        let number = usize::from(self.image.data(name)?);
        self.image.data.get(number).filter(|data| data.public || private_too)?;
        self.data.get(number).copied().map(Imported::Data)
    }
}

fn is_data(data: &DataDef, kind: &ValueType, container: Container) -> bool {
    let fits = match (&data.init.shape, container) {
        (ContainerShape::Array { dims, .. }, Container::Array { dims: wanted }) => *dims == wanted,
        (ContainerShape::Array { dims, .. }, Container::Element) => *dims == 1,
        (ContainerShape::Collection(_), Container::Collection) => true,
        _ => false,
    };
    fits && is_same(&data.init.kind, kind)
}

fn is_param(own: &ProgramParam, kind: &ValueType, container: Container, by_reference: bool) -> bool {
    let own_reference = matches!(own.storage, Storage::Place(_) | Storage::View(_));
    own.container == container && own_reference == by_reference && is_same(&own.kind, kind)
}

/// Whether the types are the same. Two user types are the same if they have the same fields; their names and the
/// fields' initial values do not count.
fn is_same(one: &ValueType, other: &ValueType) -> bool {
    match (&one.base, &other.base) {
        (KindBase::Builtin(one, arm), KindBase::Builtin(other, other_arm)) => {
            one == other && (arm == other_arm || arm.is_none() || other_arm.is_none())
        }
        (KindBase::User(_), KindBase::User(_)) => {
            let pairs = || one.fields.iter().zip(&other.fields);
            one.fields.len() == other.fields.len()
                && pairs().all(|(one, other)| one.name == other.name && is_same(&one.init.kind, &other.init.kind))
        }
        _ => false,
    }
}
