//! Serial lines and sockets whose other end is a script.

use super::ChannelTable;
use crate::sio::{ChannelConfig, LineKind, ScriptedLine};

impl ChannelTable {
    /// Connects the script as the other end of a line, in place of the outside. The line keeps its kind and its
    /// parameters.
    pub fn connect_script(&mut self, link: &str) {
        let known = self.channel_of(link).map(|channel| (channel.kind(), channel.state()));
        let kind = known.as_ref().map_or_else(|| kind_of(link), |(kind, _)| *kind);
        let (line, peer) = ScriptedLine::pair(kind);
        let config = ChannelConfig { link: link.to_owned(), kind, settings: Vec::new() };
        // Only settings can be rejected.
        let Ok(mut channel) = self.recorded(&config, Box::new(line)) else { return };
        if let Some((_, state)) = known {
            channel.channel.restore(state);
        }
        self.put(link, channel, false);
        let number = self.number(link) as usize;
        if let Some(known) = self.lines.get_mut(number) {
            known.script = Some(peer);
        }
    }

    /// Whether a script is the other end of a line.
    #[must_use]
    pub fn are_scripted(&self) -> bool {
        self.lines.iter().any(|known| known.script.is_some())
    }

    /// Sends bytes from the script to the controller over a line.
    ///
    /// # Errors
    /// The script is not the other end of the line.
    pub(crate) fn receive_from_script(&mut self, link: &str, bytes: &[u8]) -> Result<(), String> {
        let number = self.number(link) as usize;
        let peer = self.lines.get(number).and_then(|known| known.script.as_ref());
        let peer = peer.ok_or_else(|| format!("`{link}` is connected to the outside, from where its input comes"))?;
        // A restored controller receives the recorded input again.
        self.inputs.ask(|| peer.send(bytes));
        Ok(())
    }

    /// Stores the output of a task over a line whose other end is a script.
    pub(super) fn keep_output(&mut self, number: Option<u32>, bytes: &[u8]) {
        let known = number.and_then(|number| self.lines.get(number as usize));
        if let Some(known) = known.filter(|known| known.script.is_some()) {
            self.output.entry(known.link.to_ascii_lowercase()).or_default().extend(bytes);
        }
    }

    /// The output of the cycle over a line whose other end is a script.
    pub(crate) fn output(&self, link: &str) -> &[u8] {
        self.output.get(&link.to_ascii_lowercase()).map(Vec::as_slice).unwrap_or_default()
    }

    /// Discards the output of the cycle.
    pub(crate) fn forget_output(&mut self) {
        self.output.clear();
    }

    fn channel_of(&mut self, link: &str) -> Option<&mut crate::sio::Channel> {
        let number = self.number(link);
        self.channel(Some(number))
    }
}

/// Kind of an unconfigured line, according to the beginning of the link.
fn kind_of(link: &str) -> LineKind {
    match link.split_once('\\').map(|(device, _)| device.to_ascii_lowercase()).as_deref() {
        Some("serial") => LineKind::Serial,
        Some("udpsocket") => LineKind::Udp,
        _ => LineKind::Client,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::inputs::Inputs;
    use crate::sio::Attempt;

    const HOST: &str = r"Socket\host";

    fn read(lines: &mut ChannelTable) -> Option<String> {
        match lines.channel_of("socket\\HOST").unwrap().read_text(0.0) {
            Attempt::Done(text) => Some(text.unwrap()),
            Attempt::Wait => None,
        }
    }

    #[test]
    fn input_of_a_script_arrives_once_even_after_a_snapshot_is_restored() {
        let inputs = Inputs::default();
        let mut lines = ChannelTable::new(inputs.clone());
        assert!(lines.receive_from_script(HOST, b"a\r").is_err(), "no line waits for the text");
        lines.connect_script(HOST);
        let (mark, state) = (inputs.mark(), lines.state());
        for _ in 0..2 {
            lines.receive_from_script(HOST, b"a\r").unwrap();
            assert_eq!((read(&mut lines).as_deref(), read(&mut lines)), (Some("a"), None));
            lines.restore(&state);
            inputs.rewind(mark);
        }
    }

    #[test]
    fn a_line_keeps_its_kind_and_its_parameters() {
        let mut lines = ChannelTable::new(Inputs::default());
        lines.connect_script(r"Serial\1");
        lines.channel_of(r"Serial\1").unwrap().set(&crate::sio::LineSetting::EndOfString(b'!')).unwrap();
        lines.connect_script(r"Serial\1");
        lines.receive_from_script(r"Serial\1", b"a!").unwrap();
        let channel = lines.channel_of(r"Serial\1").unwrap();
        assert_eq!((channel.kind(), channel.read_text(0.0)), (LineKind::Serial, Attempt::Done(Ok("a".to_owned()))));
        assert!(lines.are_scripted() && !lines.reach_outside());
        lines.connect_script(HOST);
        assert_eq!(lines.channel_of(HOST).unwrap().kind(), LineKind::Client);
    }
}
