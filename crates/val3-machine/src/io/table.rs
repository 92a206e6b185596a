//! All inputs and outputs, their links, and the two images of their values.

use std::collections::{BTreeMap, BTreeSet};

use super::bus::DeviceFault;
use super::signal::{Direction, Kind, Signal};
use super::status::SignalFault;

/// A signal of the table.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SignalId(u32);

/// The value of a `dio` or `aio` variable: the text of its link. Copying it is `dioLink` and `aioLink`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct LinkId(u32);

impl LinkId {
    /// No link, which a variable holds at first.
    pub const NONE: Self = Self(0);

    /// The number that a variable keeps.
    #[must_use]
    pub const fn number(self) -> u32 {
        self.0
    }

    /// The link whose number a variable keeps.
    #[must_use]
    pub const fn from_number(number: u32) -> Self {
        Self(number)
    }
}

/// A signal has another value, seen from the program for an input, from the outside for an output.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct IoChange {
    /// The signal.
    pub signal: SignalId,
    /// Its value; 0 or 1 for a digital one.
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
    /// The value at which the operator holds it.
    pub(super) lock: Option<f64>,
    pub(super) simulated: bool,
    pub(super) fault: Option<SignalFault>,
}

/// The text of a link and where it leads.
#[derive(Debug, Clone)]
struct Link {
    text: String,
    target: Option<SignalId>,
}

/// Inputs and outputs with two images (5.7): programs see inputs as they were when the cycle began, and the hardware
/// gets outputs when it ends. A program reads back at once what it has written.
#[derive(Debug, Clone, Default)]
pub struct IoTable {
    pub(super) channels: Vec<Channel>,
    links: Vec<Link>,
    by_text: BTreeMap<String, LinkId>,
    by_path: BTreeMap<String, SignalId>,
    /// Paths of signals by the names that the cell gives them.
    names: BTreeMap<String, String>,
    units: BTreeMap<String, String>,
    /// The devices of declared signals; those of applications do not count.
    devices: BTreeSet<String>,
    pub(super) device_faults: Vec<DeviceFault>,
    pub(super) to_refresh: BTreeSet<SignalId>,
}

impl IoTable {
    /// Adds a signal, with the value 0. The first one of a path stays.
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

    /// Gives the signal of a path a name, which links, scripts and users may write instead: `bOut7`.
    pub fn name_signal(&mut self, name: &str, path: &str) {
        self.names.insert(name.to_owned(), path.to_owned());
        self.resolve_links();
    }

    /// The names of signals.
    pub(crate) fn names(&self) -> impl Iterator<Item = &str> {
        self.names.keys().map(String::as_str)
    }

    /// Names the units of analog signals for people, by path. The signals need not be declared yet.
    pub fn set_units(&mut self, units: BTreeMap<String, String>) {
        self.units = units;
    }

    /// The unit of an analog signal, such as `bar`; none if it is not known.
    #[must_use]
    pub fn unit(&self, id: SignalId) -> Option<&str> {
        self.units.get(&self.signal(id)?.path).map(String::as_str)
    }

    /// The link of this text. It need not lead anywhere; an empty one is [`LinkId::NONE`].
    pub fn link(&mut self, text: &str) -> LinkId {
        if text.is_empty() {
            return LinkId::NONE;
        }
        if let Some(known) = self.by_text.get(text) {
            return *known;
        }
        self.links.push(Link { text: text.to_owned(), target: self.find(text) });
        let id = LinkId(u32::try_from(self.links.len()).unwrap_or(u32::MAX));
        self.by_text.insert(text.to_owned(), id);
        id
    }

    /// The link of a variable of an application. If nothing is configured of its device, the application knows best:
    /// the signal is declared by [`Signal::from_path`].
    pub fn adopt(&mut self, text: &str, digital: bool) -> LinkId {
        if !text.is_empty() && self.find(text).is_none() && !self.knows_device_of(text) {
            self.add(Signal::from_path(text, digital));
        }
        self.link(text)
    }

    /// The signal of a path or of a name. A path without a device (`valve1`) finds the signal of this address in any device.
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

    /// The configuration of the signal of a link.
    pub(super) fn signal_of(&self, link: LinkId) -> Option<&Signal> {
        self.signal(self.target_of(link)?)
    }

    /// Where a link leads.
    #[must_use]
    pub fn target_of(&self, link: LinkId) -> Option<SignalId> {
        self.known_link(link)?.target
    }

    /// Where a link leads, if that suits a variable of this kind.
    pub(super) fn target(&self, link: LinkId, kind: Kind) -> Option<SignalId> {
        let id = self.target_of(link)?;
        self.channel(id).filter(|channel| channel.signal.kind.suits(kind)).map(|_| id)
    }

    pub(super) fn channel(&self, id: SignalId) -> Option<&Channel> {
        self.channels.get(id.0 as usize)
    }

    pub(super) fn channel_mut(&mut self, id: SignalId) -> Option<&mut Channel> {
        self.channels.get_mut(id.0 as usize)
    }

    /// Begins a cycle: programs see the current inputs.
    pub fn refresh_inputs(&mut self) -> Vec<IoChange> {
        self.refresh(Direction::Input, Channel::refresh_input)
    }

    /// The cycle ends: the hardware gets the outputs.
    pub fn refresh_outputs(&mut self) -> Vec<IoChange> {
        self.refresh(Direction::Output, Channel::refresh_output)
    }

    /// Refreshes the signals of one direction that have changed; gives those that `refresh` gives a new value.
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

    /// The configuration of the cell, and not the application alone, names the signals of the device of this path.
    pub(crate) fn is_configured(&self, path: &str) -> bool {
        self.knows_device_of(path)
    }

    /// A signal of this device or module exists.
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

    fn known_link(&self, link: LinkId) -> Option<&Link> {
        self.links.get((link.0 as usize).checked_sub(1)?)
    }

    /// Leads the links that led nowhere to a new signal.
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

    /// The value, if it is another one than before.
    fn tell(&mut self) -> Option<f64> {
        (std::mem::replace(&mut self.told, self.image) != self.image).then_some(self.image)
    }
}
