//! Field bus devices that have failed (`ioBusStatus`, 8.1).

use std::collections::BTreeMap;

use super::status::{IoStatus, SignalFault};
use super::table::{Channel, IoTable};

/// A device of a field bus that has failed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DeviceFault {
    /// Device and module, as paths begin: `J207\Box1`, or a device without modules: `BasicIO-1`.
    pub device: String,
    /// The number of the fault, which depends on the bus.
    pub code: i32,
}

impl DeviceFault {
    fn holds(&self, channel: &Channel) -> bool {
        let rest = channel.signal.path.strip_prefix(self.device.as_str());
        rest.is_some_and(|rest| rest.starts_with('\\'))
    }
}

impl IoTable {
    /// A device or module fails with a number of its bus, or works again with `None`. All its signals have failed with
    /// it.
    pub fn set_device_fault(&mut self, device: &str, code: Option<i32>) {
        self.device_faults.retain(|fault| fault.device != device);
        self.device_faults.extend(code.map(|code| DeviceFault { device: device.to_owned(), code }));
    }

    /// `ioBusStatus`: a text for each device that has failed, `number:device\module`; their count is its result.
    ///
    /// A module of which a signal has failed alone counts as well, with the number -3.
    #[must_use]
    pub fn bus_faults(&self) -> Vec<String> {
        let failed = self.channels.iter().filter(|channel| channel.fault == Some(SignalFault::Failed));
        let modules = failed.filter_map(|channel| channel.signal.path.rsplit_once('\\')).map(|(module, _)| module);
        let mut faults: BTreeMap<&str, i32> =
            modules.map(|module| (module, IoStatus::Failed.number().into())).collect();
        faults.extend(self.device_faults.iter().map(|fault| (fault.device.as_str(), fault.code)));
        faults.into_iter().map(|(device, code)| format!("{code}:{device}")).collect()
    }

    /// The fault of a signal: its own, or that of its device.
    pub(super) fn fault_of(&self, channel: &Channel) -> Option<SignalFault> {
        let of_device = || self.device_faults.iter().any(|fault| fault.holds(channel)).then_some(SignalFault::Failed);
        channel.fault.or_else(of_device)
    }
}
