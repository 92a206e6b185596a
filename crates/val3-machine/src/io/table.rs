//! Inputs and outputs, with links and the two images of the values.

use std::collections::{BTreeMap, BTreeSet};

use super::bus::DeviceFault;
use super::signal::{Direction, Signal, SignalKind};
use super::status::SignalFault;

/// A signal of the table.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SignalId(u32);

/// Value of a `dio` or `aio` variable: the text of the link. `dioLink` and `aioLink` copy it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct LinkId(u32);

impl LinkId {
    /// No link, the initial value of a variable.
    pub const NONE: Self = Self(0);

    /// Number that a variable stores.
    #[must_use]
    pub const fn number(self) -> u32 {
        self.0
    }

    /// Link with the number that a variable stores.
    #[must_use]
    pub const fn from_number(number: u32) -> Self {
        Self(number)
    }
}

/// Changed value of a signal: an input as programs read it, or an output as the outside receives it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct IoChange {
    /// The signal.
    pub signal: SignalId,
    /// New value; 0 or 1 for a digital signal.
    pub value: f64,
}

/// A signal and its state.
#[derive(Debug, Clone)]
pub(super) struct Channel {
    pub(super) signal: Signal,
    /// The value that programs read and write.
    pub(super) image: f64,
    /// The value at the terminal.
    pub(super) hardware: f64,
    /// The last reported value.
    told: f64,
    /// Value at which the operator locks the signal.
    pub(super) lock: Option<f64>,
    pub(super) simulated: bool,
    pub(super) fault: Option<SignalFault>,
}

/// Text of a link and the signal that it resolves to.
#[derive(Debug, Clone)]
struct LinkText {
    text: String,
    target: Option<SignalId>,
}

/// Inputs and outputs with two images (5.7): programs read the inputs' state at the start of the cycle, and the
/// hardware receives the outputs at its end. A program reads a written output back immediately.
#[derive(Debug, Clone, Default)]
pub struct IoTable {
    pub(super) channels: Vec<Channel>,
    links: Vec<LinkText>,
    by_text: BTreeMap<String, LinkId>,
    by_path: BTreeMap<String, SignalId>,
    /// Signal paths by the names in the cell's configuration.
    names: BTreeMap<String, String>,
    units: BTreeMap<String, String>,
    /// Devices of declared signals, without signals that only an application names.
    devices: BTreeSet<String>,
    pub(super) device_faults: Vec<DeviceFault>,
    pub(super) to_refresh: BTreeSet<SignalId>,
    /// Whether writes set inputs like the hardware.
    pub(super) forces_inputs: bool,
}

impl IoTable {
    /// Adds a signal with the value 0. A signal that was declared before under the same path stays.
    pub fn declare(&mut self, signal: Signal) -> SignalId {
        if let Some((device, _)) = signal.path.split_once('\\') {
            self.devices.insert(device.to_owned());
        }
        self.add(signal)
    }

    fn add(&mut self, signal: Signal) -> SignalId {
        if let Some(known) = self.by_path.get(&signal.path) {
            return *known;
        }
        let id = SignalId(u32::try_from(self.channels.len()).unwrap_or(u32::MAX));
        self.by_path.insert(signal.path.clone(), id);
        self.channels.push(Channel::new(signal));
        self.resolve_links();
        id
    }

    /// Sets the name of a signal. Links, scripts and users may write the name instead of the path: `bOut7`.
    pub fn name_signal(&mut self, name: &str, path: &str) {
        self.names.insert(name.to_owned(), path.to_owned());
        self.resolve_links();
    }

    /// The names of signals.
    pub(crate) fn names(&self) -> impl Iterator<Item = &str> {
        self.names.keys().map(String::as_str)
    }

    /// Sets the displayed units of analog signals, by path. The signals need not be declared yet.
    pub fn set_units(&mut self, units: BTreeMap<String, String>) {
        self.units = units;
    }

    /// Unit for an analog signal, such as `bar`; `None` if unknown.
    #[must_use]
    pub fn unit(&self, id: SignalId) -> Option<&str> {
        self.units.get(&self.signal(id)?.path).map(String::as_str)
    }

    /// Returns the link with this text, also if no such signal exists. The empty text has the link [`LinkId::NONE`].
    pub fn link(&mut self, text: &str) -> LinkId {
        if text.is_empty() {
            return LinkId::NONE;
        }
        if let Some(known) = self.by_text.get(text) {
            return *known;
        }
        self.links.push(LinkText { text: text.to_owned(), target: self.find(text) });
        let id = LinkId(u32::try_from(self.links.len()).unwrap_or(u32::MAX));
        self.by_text.insert(text.to_owned(), id);
        id
    }

    /// Returns the link with this text. If no such signal exists and the cell does not configure its device, declares
    /// the signal by [`Signal::from_path`].
    pub fn adopt(&mut self, text: &str, digital: bool) -> LinkId {
        if !text.is_empty() && self.find(text).is_none() && !self.knows_device_of(text) {
            self.add(Signal::from_path(text, digital));
        }
        self.link(text)
    }

    /// Finds a signal by path or name. A path without a device (`valve1`) finds the signal with this address in any
    /// device.
    #[must_use]
    pub fn find(&self, path: &str) -> Option<SignalId> {
        let exact = self.by_path.get(path).or_else(|| self.by_path.get(self.names.get(path)?)).copied();
        exact.or_else(|| if path.contains('\\') { None } else { self.find_address(path) })
    }

    /// The configuration of a signal.
    #[must_use]
    pub fn signal(&self, id: SignalId) -> Option<&Signal> {
        self.channel(id).map(|channel| &channel.signal)
    }

    /// Every signal, in the order of declaration.
    pub fn signals(&self) -> impl Iterator<Item = SignalId> + use<> {
        (0..u32::try_from(self.channels.len()).unwrap_or(u32::MAX)).map(SignalId)
    }

    /// The text of a link, empty for [`LinkId::NONE`].
    #[must_use]
    pub fn text(&self, link: LinkId) -> &str {
        self.known_link(link).map_or("", |link| link.text.as_str())
    }

    /// Configuration of the linked signal.
    pub(super) fn signal_of(&self, link: LinkId) -> Option<&Signal> {
        self.signal(self.target_of(link)?)
    }

    /// Signal that the link resolves to.
    #[must_use]
    pub fn target_of(&self, link: LinkId) -> Option<SignalId> {
        self.known_link(link)?.target
    }

    /// Signal that the link resolves to, if it suits a variable of this kind.
    pub(super) fn target(&self, link: LinkId, kind: SignalKind) -> Option<SignalId> {
        let id = self.target_of(link)?;
        self.channel(id).filter(|channel| channel.signal.kind.suits(kind)).map(|_| id)
    }

    pub(super) fn channel(&self, id: SignalId) -> Option<&Channel> {
        self.channels.get(id.0 as usize)
    }

    pub(super) fn channel_mut(&mut self, id: SignalId) -> Option<&mut Channel> {
        self.channels.get_mut(id.0 as usize)
    }

    /// Begins a cycle: updates the inputs that programs read.
    pub fn refresh_inputs(&mut self) -> Vec<IoChange> {
        self.refresh(Direction::Input, Channel::refresh_input)
    }

    /// Lets programs read changed inputs before the next cycle, which still reports the changes. A debugger calls it
    /// after a change of inputs while the run is stopped.
    pub fn show_inputs(&mut self) {
        for id in self.to_refresh.clone() {
            if let Some(channel) = self.channel_mut(id).filter(|channel| channel.signal.direction == Direction::Input) {
                channel.image = channel.lock.unwrap_or(channel.hardware);
            }
        }
    }

    /// Ends a cycle: writes the outputs to the hardware.
    pub fn refresh_outputs(&mut self) -> Vec<IoChange> {
        self.refresh(Direction::Output, Channel::refresh_output)
    }

    /// Refreshes the changed signals in one direction. Returns the new values that `refresh` reports.
    fn refresh(&mut self, direction: Direction, refresh: fn(&mut Channel) -> Option<f64>) -> Vec<IoChange> {
        let mut changes = Vec::new();
        for id in std::mem::take(&mut self.to_refresh) {
            match self.channel_mut(id) {
                Some(channel) if channel.signal.direction == direction => {
                    changes.extend(refresh(channel).map(|value| IoChange { signal: id, value }));
                }
                _ => {
                    self.to_refresh.insert(id);
                }
            }
        }
        changes
    }

    /// Whether the cell's configuration, not only the application, declares signals of the path's device.
    pub(crate) fn is_configured(&self, path: &str) -> bool {
        self.knows_device_of(path)
    }

    /// Whether a signal of this device or module exists.
    pub(crate) fn has_device(&self, device: &str) -> bool {
        let holds = |path: &String| path.strip_prefix(device).is_some_and(|rest| rest.starts_with('\\'));
        self.by_path.keys().any(holds)
    }

    fn find_address(&self, address: &str) -> Option<SignalId> {
        let named = |path: &str| path.rsplit('\\').next() == Some(address);
        self.by_path.iter().find(|(path, _)| named(path)).map(|(_, id)| *id)
    }

    fn knows_device_of(&self, path: &str) -> bool {
        path.split_once('\\').is_some_and(|(device, _)| self.devices.contains(device))
    }

    fn known_link(&self, link: LinkId) -> Option<&LinkText> {
        self.links.get((link.0 as usize).checked_sub(1)?)
    }

    /// Resolves the unresolved links again.
    fn resolve_links(&mut self) {
        let mut links = std::mem::take(&mut self.links);
        for link in links.iter_mut().filter(|link| link.target.is_none()) {
            link.target = self.find(&link.text);
        }
        self.links = links;
    }
}

impl Channel {
    fn new(signal: Signal) -> Self {
        Self { signal, image: 0.0, hardware: 0.0, told: 0.0, lock: None, simulated: false, fault: None }
    }

    fn refresh_input(&mut self) -> Option<f64> {
        self.image = self.lock.unwrap_or(self.hardware);
        self.tell()
    }

    fn refresh_output(&mut self) -> Option<f64> {
        if self.simulated {
            return None;
        }
        self.hardware = self.image;
        self.tell()
    }

    /// Returns the value if it has changed since the last report.
    fn tell(&mut self) -> Option<f64> {
        (std::mem::replace(&mut self.told, self.image) != self.image).then_some(self.image)
    }
}
