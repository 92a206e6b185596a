//! Serial lines and sockets whose other end is a script.

use super::Lines;
use crate::sio::{ChannelConfig, LineKind, ScriptedLine};

impl Lines {
    /// Makes the script the other end of a line, in place of the outside. The line keeps its kind and its parameters.
    pub fn connect_script(&mut self, link: &str) {
        let known = self.channel_of(link).map(|channel| (channel.kind(), channel.state()));
        let kind = known.as_ref().map_or_else(|| kind_of(link), |(kind, _)| *kind);
        let (line, peer) = ScriptedLine::pair(kind);
        let config = ChannelConfig { link: link.to_owned(), kind, settings: Vec::new() };
        // Only settings can be refused.
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

    /// Lets a text come in over a line.
    ///
    /// # Errors
    /// The script is not its other end.
    pub(crate) fn receive_from_script(&mut self, link: &str, text: &str) -> Result<(), String> {
        let number = self.number(link) as usize;
        let peer = self.lines.get(number).and_then(|known| known.script.as_ref());
        let peer = peer.ok_or_else(|| format!("`{link}` is connected to the outside, from where its input comes"))?;
        // A restored controller receives the recorded input again.
        self.inputs.ask(|| peer.send(text.as_bytes()));
        Ok(())
    }

    fn channel_of(&mut self, link: &str) -> Option<&mut crate::sio::Channel> {
        let number = self.number(link);
        self.channel(Some(number))
    }
}

/// The kind of a line that is not configured, by the beginning of its link.
fn kind_of(link: &str) -> LineKind {
    match link.split_once('\\').map(|(device, _)| device.to_ascii_lowercase()).as_deref() {
        Some("serial") => LineKind::Serial,
        Some("udpsocket") => LineKind::Udp,
        _ => LineKind::Client,
    }
}
