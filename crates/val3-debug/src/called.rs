//! Resolution of the programs that lines call.

use val3_bytecode::{CallSite, ProgramRef};
use val3_vm::{Imported, InstanceId, Vm};

/// Returns the program that a call site calls; `None` while its library is not loaded.
pub(crate) fn called_program(vm: &Vm, caller: InstanceId, site: &CallSite) -> Option<(InstanceId, u16)> {
    match site.program {
        ProgramRef::Own(number) => Some((caller, number)),
        ProgramRef::Import(number) => match vm.space.instance(caller)?.imports.get(usize::from(number)) {
            Some(Some(Imported::Program(instance, number))) => Some((*instance, *number)),
            _ => None,
        },
    }
}
