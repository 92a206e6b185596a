//! Sessions of clients.

use std::collections::BTreeMap;
use std::time::Duration;

use val3_session::ProfileRights;

use crate::inferred::{MOST_SESSIONS, SESSION_SECONDS};

/// Open sessions. Times are since the start of the service.
#[derive(Debug, Default)]
pub(crate) struct Sessions {
    open: BTreeMap<i32, OpenSession>,
    last: i32,
}

/// Session of a client.
#[derive(Debug)]
struct OpenSession {
    rights: ProfileRights,
    /// Time of the last request.
    used: Duration,
}

impl Sessions {
    /// Opens a session. Returns its number; `None` if too many sessions are open.
    pub(crate) fn open(&mut self, rights: ProfileRights, now: Duration) -> Option<i32> {
        self.expire(now);
        if self.open.len() >= MOST_SESSIONS {
            return None;
        }
        // Numbers are positive, and no number is used twice in a row.
        loop {
            self.last = self.last.checked_add(1).unwrap_or(1);
            if !self.open.contains_key(&self.last) {
                break;
            }
        }
        self.open.insert(self.last, OpenSession { rights, used: now });
        Some(self.last)
    }

    /// Session of a request: the named session, or the only open session if the request names none. Its time starts
    /// again.
    pub(crate) fn resume(&mut self, named: Option<i32>, now: Duration) -> Option<(i32, ProfileRights)> {
        self.expire(now);
        let id = named.or_else(|| self.only())?;
        let session = self.open.get_mut(&id)?;
        session.used = now;
        Some((id, session.rights))
    }

    /// Closes a session.
    pub(crate) fn close(&mut self, id: i32) {
        self.open.remove(&id);
    }

    /// Whether a session is open.
    pub(crate) fn is_open(&mut self, id: i32, now: Duration) -> bool {
        self.expire(now);
        self.open.contains_key(&id)
    }

    /// The open session if there is exactly one.
    pub(crate) fn only(&self) -> Option<i32> {
        let mut ids = self.open.keys();
        ids.next().copied().filter(|_| ids.next().is_none())
    }

    /// Closes the sessions without a request for too long.
    fn expire(&mut self, now: Duration) {
        let longest = Duration::from_secs(SESSION_SECONDS);
        self.open.retain(|_, session| now.saturating_sub(session.used) <= longest);
    }
}
