//! Access to an element that does not exist, with which a task has failed.

use std::fmt::{self, Display};

use val3_bytecode::{ContainerKind, ContainerRef, Op, Register, Storage, TextOperand};
use val3_lang::memory::{ContainerShape, Memory};
use val3_lang::ports::TaskNumber;
use val3_lang::values::number_text::significant;
use val3_lang::values::printed;

use crate::Vm;
use crate::operands::OperandContext;

/// Container, and the indexes or the key of the element that it does not have.
#[derive(Debug, Clone, PartialEq)]
pub struct FailedAccess {
    /// Name by which the program accesses the container; `None` for a field of a user type.
    name: Option<String>,
    element: MissingElement,
}

#[derive(Debug, Clone, PartialEq)]
enum MissingElement {
    Indexes { indexes: Vec<f64>, sizes: Vec<u32> },
    Key(String),
}

impl Display for FailedAccess {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = |unnamed: &str| self.name.as_ref().map_or_else(|| unnamed.to_owned(), |name| format!("`{name}`"));
        match &self.element {
            MissingElement::Key(key) => {
                write!(f, "{} has no key {}", name("the collection"), printed::string(key))
            }
            MissingElement::Indexes { indexes, sizes } => {
                let indexes: Vec<_> = indexes.iter().map(|index| significant(*index).as_str().to_owned()).collect();
                let sizes: Vec<_> = sizes.iter().map(ToString::to_string).collect();
                let plural = if indexes.len() > 1 { "indexes are" } else { "index is" };
                let (indexes, sizes) = (indexes.join(","), sizes.join(","));
                write!(f, "the {plural} {indexes}, and {} has the size {sizes}", name("the array"))
            }
        }
    }
}

impl Vm {
    /// Returns the element that an operation of a failed task has not found. `None` for accesses within instructions
    /// and calls.
    pub fn failed_access(&mut self, task: TaskNumber) -> Option<FailedAccess> {
        let thread = &self.tasks().iter().find(|known| known.id == task)?.thread;
        let (frame, op) = (*thread.frames.last()?, thread.failed?);
        let instance = self.space.instance(frame.instance)?.clone();
        let program = instance.image.programs.get(usize::from(frame.program))?;
        let context = OperandContext { instance: &instance, program, base: frame.base };
        let op = program.code.get(op as usize)?.op;
        self.with_stack(task, |memory| context.missing_element(memory, op))?
    }
}

impl OperandContext<'_> {
    fn missing_element(&self, memory: &Memory, op: Op) -> Option<FailedAccess> {
        match op {
            Op::LoadElement { container, index, .. }
            | Op::StoreElement { container, index, .. }
            | Op::ElementField { container, index, .. }
            | Op::Locate { container, index, .. } => self.missing_index(memory, container, &[index]),
            Op::LoadElement2 { container, i, j, .. }
            | Op::StoreElement2 { container, i, j, .. }
            | Op::Locate2 { container, i, j, .. } => self.missing_index(memory, container, &[i, j]),
            Op::Locate3 { container, i, .. } => {
                self.missing_index(memory, container, &[i, i.checked_add(1)?, i.checked_add(2)?])
            }
            Op::LoadKey { container, key, .. }
            | Op::StoreKey { container, key, .. }
            | Op::LocateKey { container, key, .. } => self.missing_key(memory, container, key),
            _ => None,
        }
    }

    fn missing_index(&self, memory: &Memory, container: ContainerRef, indexes: &[Register]) -> Option<FailedAccess> {
        let view = self.view(memory, container).ok()?;
        let ContainerShape::Array { dims, sizes } = memory.store(view.store).ok()?.shape else { return None };
        let mut sizes = sizes.get(..usize::from(dims))?.to_vec();
        // Only arrays of one dimension are passed from an index on.
        if let [size] = sizes.as_mut_slice() {
            *size = size.checked_sub(view.start)?;
        }
        let indexes = indexes.iter().map(|index| self.num(memory, *index).ok()).collect::<Option<_>>()?;
        Some(FailedAccess { name: self.name(container), element: MissingElement::Indexes { indexes, sizes } })
    }

    fn missing_key(&self, memory: &Memory, container: ContainerRef, key: TextOperand) -> Option<FailedAccess> {
        let key = self.text(memory, key).ok()?.as_str().to_owned();
        Some(FailedAccess { name: self.name(container), element: MissingElement::Key(key) })
    }

    /// Returns the name by which the program accesses a container; `None` if the container is part of a value.
    fn name(&self, container: ContainerRef) -> Option<String> {
        let image = &self.instance.image;
        let storage = match container.kind() {
            ContainerKind::Data(number) => return Some(image.data.get(usize::from(number))?.name.clone()),
            ContainerKind::Import(number) => {
                let import = image.imports.get(usize::from(number))?;
                let library = image.libraries.get(usize::from(import.library))?;
                return Some(format!("{}:{}", library.alias, import.name));
            }
            ContainerKind::Builtin(_) => return None,
            ContainerKind::Part(number) => Storage::Part(number),
            ContainerKind::View(number) => Storage::View(number),
        };
        self.program.variables.iter().find(|variable| variable.storage == storage).map(|found| found.name.clone())
    }
}
