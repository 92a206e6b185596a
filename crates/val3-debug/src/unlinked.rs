//! Inputs, outputs and serial lines without a signal, in a line that has failed.

use std::fmt;

use val3_lang::fault::Fault;
use val3_lang::memory::LinkPlace;
use val3_lang::ports::TaskNumber;
use val3_lang::runtime_errors::UNLINKED;
use val3_lang::types::BaseType;
use val3_machine::controller::Controller;
use val3_machine::devices::Devices;
use val3_vm::FragmentContext;

use crate::watched::WatchedData;

/// Variable that is linked to no signal of this controller.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct UnlinkedData {
    /// Data path, for example `diPart[2]`; the path of the array if several elements have no signal.
    path: String,
    /// Link for which there is no signal or line; `None` if the variable has no link.
    link: Option<String>,
    /// Whether the variable is a `sio`.
    is_line: bool,
}

impl fmt::Display for UnlinkedData {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.link {
            Some(link) => {
                let object = if self.is_line { "line" } else { "signal" };
                write!(f, "`{}` has the link `{link}`, but this controller has no such {object}", self.path)
            }
            None => write!(f, "`{}` has no link", self.path),
        }
    }
}

/// Returns the variables without a signal in the line at which a run-time error has stopped the task: global data of the
/// program's application, parameters and locals.
pub(crate) fn unlinked(controller: &mut Controller, task: TaskNumber) -> Vec<UnlinkedData> {
    let vm = &controller.vm;
    let Some(thread) = vm.tasks().iter().find(|known| known.id == task).map(|task| &task.thread) else {
        return Vec::new();
    };
    let Some((frame, op)) = thread.frames.last().map(|frame| (*frame, thread.line)) else { return Vec::new() };
    let Some(image) = vm.space.instance(frame.instance).map(|instance| &instance.image) else { return Vec::new() };
    let program = image.programs.get(usize::from(frame.program));
    let locals = program.into_iter().flat_map(|program| program.variables.iter().map(|variable| variable.name.clone()));
    let names: Vec<String> = locals.chain(image.data.iter().map(|data| data.name.clone())).collect();
    let mut found = Vec::new();
    for name in names {
        let Ok(data) = WatchedData::new(controller, FragmentContext::Frame(task, 0), &name) else { continue };
        let ports = data.ports(controller);
        if let Some(unlinked) = faulty(&name, &ports, &controller.devices)
            && data.is_read(controller, task, frame, op)
            && !found.contains(&unlinked)
        {
            found.push(unlinked);
        }
    }
    found
}

/// Returns the element without a signal; for several such elements, the array.
fn faulty(name: &str, ports: &[(BaseType, LinkPlace)], devices: &Devices) -> Option<UnlinkedData> {
    let mut elements = ports.iter().enumerate().filter(|(_, (base, link))| !has_signal(devices, *base, *link));
    let (at, (base, link)) = elements.next()?;
    let is_line = *base == BaseType::Sio;
    if elements.next().is_some() {
        return Some(UnlinkedData { path: name.to_owned(), link: None, is_line });
    }
    let link = match link {
        LinkPlace::Port(port) => devices.port_name(*base, *port).filter(|text| !text.is_empty()).map(str::to_owned),
        LinkPlace::None | LinkPlace::Data(_) => None,
    };
    let path = if ports.len() > 1 { format!("{name}[{at}]") } else { name.to_owned() };
    Some(UnlinkedData { path, link, is_line })
}

fn has_signal(devices: &Devices, base: BaseType, link: LinkPlace) -> bool {
    let LinkPlace::Port(port) = link else { return false };
    let read = match base {
        BaseType::Dio => devices.digital(port).map(drop),
        BaseType::Aio => devices.analog(port).map(drop),
        BaseType::Sio if !devices.has_line(port) => Err(Fault(UNLINKED)),
        _ => Ok(()),
    };
    read != Err(Fault(UNLINKED))
}
