//! Passwords in `~/.netrc`, which `ftp`, `curl` and `lftp` read too.

/// Returns the password of a user at a host; `None` without an entry.
///
/// An entry without `login` is for every user. `default` is for every host. Macros end with an empty line.
pub(super) fn password(text: &str, host: &str, user: &str) -> Option<String> {
    let mut entries = Entries::default();
    let mut in_macro = false;
    for line in text.lines() {
        if in_macro {
            in_macro = !line.trim().is_empty();
            continue;
        }
        let mut words = line.split_whitespace();
        while let Some(word) = words.next().filter(|word| !word.starts_with('#')) {
            match word {
                // A profile may be called `default`.
                value if entries.expects_value() => entries.value(value),
                "macdef" => {
                    in_macro = true;
                    break;
                }
                "default" => entries.begin(None),
                "machine" => entries.begin_next = true,
                "login" | "password" | "account" => entries.field = word.to_owned(),
                _ => {}
            }
        }
    }
    entries.list.iter().find(|entry| entry.is_for(host, user))?.password.clone()
}

#[derive(Default)]
struct Entry {
    /// `None` for every host.
    host: Option<String>,
    login: Option<String>,
    password: Option<String>,
}

impl Entry {
    /// Whether the entry is for this user at this host.
    fn is_for(&self, host: &str, user: &str) -> bool {
        self.host.as_deref().is_none_or(|name| name.eq_ignore_ascii_case(host))
            && self.login.as_deref().is_none_or(|login| login == user)
    }
}

#[derive(Default)]
struct Entries {
    list: Vec<Entry>,
    /// Whether the next word is a host.
    begin_next: bool,
    /// Field of the next word.
    field: String,
}

impl Entries {
    fn begin(&mut self, host: Option<String>) {
        self.list.push(Entry { host, ..Entry::default() });
    }

    /// Whether the next word is the value of a keyword.
    fn expects_value(&self) -> bool {
        self.begin_next || !self.field.is_empty()
    }

    fn value(&mut self, value: &str) {
        if std::mem::take(&mut self.begin_next) {
            return self.begin(Some(value.to_owned()));
        }
        let Some(entry) = self.list.last_mut() else { return };
        match std::mem::take(&mut self.field).as_str() {
            "login" => entry.login = Some(value.to_owned()),
            "password" => entry.password = Some(value.to_owned()),
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_entry_of_host_and_user_counts() {
        let text = "# robots\nmachine robot login maintenance password first\nmachine robot\n  login default\n  password second\n\
            macdef init\ncd machine other password none\n\nmachine other password third\ndefault login guest password fourth\n";
        for (host, user, expected) in [
            ("robot", "maintenance", Some("first")),
            ("ROBOT", "default", Some("second")),
            ("other", "anyone", Some("third")),
            ("unknown", "guest", Some("fourth")),
            ("robot", "other", None),
        ] {
            assert_eq!(password(text, host, user).as_deref(), expected, "{user}@{host}");
        }
    }
}
