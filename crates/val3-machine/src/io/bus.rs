//! Field bus devices that have failed (`ioBusStatus`, 8.1).

use std::collections::BTreeMap;

use super::status::{IoStatus, SignalFault};
use super::table::{Channel, IoTable};

/// Failed device of a field bus.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DeviceFault {
    /// Device and module, the beginning of a path: `J207\Box1`, or a device without modules: `BasicIO-1`.
    pub device: String,
    /// Number of the fault, which depends on the bus.
    pub code: i32,
}

impl DeviceFault {
    fn holds(&self, channel: &Channel) -> bool {
        let rest = channel.signal.path.strip_prefix(self.device.as_str());
        rest.is_some_and(|rest| rest.starts_with('\\'))
    }
}

impl IoTable {
    /// Sets the fault number of a device or module, or `None` if it works again. All its signals fail with it.
    pub fn set_device_fault(&mut self, device: &str, code: Option<i32>) {
        self.device_faults.retain(|fault| fault.device != device);
        self.device_faults.extend(code.map(|code| DeviceFault { device: device.to_owned(), code }));
    }

    /// `ioBusStatus`: returns a text for each failed device, `number:device\module`; their count is the instruction's
    /// result.
    ///
    /// A module with only a failed signal counts as well, with the number -3.
    #[must_use]
    pub fn bus_faults(&self) -> Vec<String> {
        let failed = self.channels.iter().filter(|channel| channel.fault == Some(SignalFault::Failed));
        let modules = failed.filter_map(|channel| channel.signal.path.rsplit_once('\\')).map(|(module, _)| module);
        let mut faults: BTreeMap<&str, i32> =
            modules.map(|module| (module, IoStatus::Failed.number().into())).collect();
        faults.extend(self.device_faults.iter().map(|fault| (fault.device.as_str(), fault.code)));
        faults.into_iter().map(|(device, code)| format!("{code}:{device}")).collect()
    }

    /// Fault of a signal or its device.
    pub(super) fn fault_of(&self, channel: &Channel) -> Option<SignalFault> {
        let of_device = || self.device_faults.iter().any(|fault| fault.holds(channel)).then_some(SignalFault::Failed);
        channel.fault.or_else(of_device)
    }
}
