//! User profiles and their rights (`getProfile`, `setProfile`, 4.3).

/// The manufacturer's profile, which no program can activate or deactivate.
const MANUFACTURER: &str = "staubli";

/// One profile.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Profile {
    /// Name.
    pub name: String,
    /// Password in plain text; empty without a password.
    pub password: String,
    /// Whether the operator may change the monitor speed.
    pub controls_speed: bool,
}

impl Profile {
    fn without_password(name: &str, controls_speed: bool) -> Self {
        Self { name: name.to_owned(), password: String::new(), controls_speed }
    }
}

/// Result of `setProfile`; the number is the result in a program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum ProfileChange {
    /// The profile is active.
    Done = 0,
    /// No profile has this name.
    Unknown = 1,
    /// The password is wrong.
    WrongPassword = 2,
    /// The manufacturer's profile cannot be entered this way.
    NotEntered = 3,
    /// The manufacturer's profile is active and cannot be left this way.
    NotLeft = 4,
}

/// Profiles of a controller, with the active profile.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Profiles {
    known: Vec<Profile>,
    active: Profile,
}

impl Default for Profiles {
    /// Creates `default`, which is active and in which programs control the speed, and `maintenance`, in which the
    /// operator does. Both have no password.
    fn default() -> Self {
        let active = Profile::without_password("default", false);
        Self { known: vec![active.clone(), Profile::without_password("maintenance", true)], active }
    }
}

impl Profiles {
    /// Creates the profiles of a controller; `active` may be a profile that `setProfile` cannot activate.
    #[must_use]
    pub fn new(known: Vec<Profile>, active: Profile) -> Self {
        Self { known, active }
    }

    /// All profiles that `setProfile` can activate.
    #[must_use]
    pub fn known(&self) -> &[Profile] {
        &self.known
    }

    /// The active profile; its name is the result of `getProfile`.
    #[must_use]
    pub fn active(&self) -> &Profile {
        &self.active
    }

    /// `setProfile`.
    pub fn change(&mut self, login: &str, password: &str) -> ProfileChange {
        if self.active.name == MANUFACTURER {
            return ProfileChange::NotLeft;
        }
        if login == MANUFACTURER {
            return ProfileChange::NotEntered;
        }
        match self.known.iter().find(|profile| profile.name == login) {
            None => ProfileChange::Unknown,
            Some(profile) if profile.password != password => ProfileChange::WrongPassword,
            Some(profile) => {
                self.active = profile.clone();
                ProfileChange::Done
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn profile(name: &str, password: &str) -> Profile {
        Profile { name: name.to_owned(), password: password.to_owned(), controls_speed: true }
    }

    fn profiles() -> Profiles {
        let known = vec![profile("default", ""), profile("setter", "1234"), profile("staubli", "x")];
        Profiles::new(known, profile("default", ""))
    }

    #[test]
    fn every_result() {
        let mut profiles = profiles();
        assert_eq!(profiles.change("nobody", "") as u8, 1);
        assert_eq!(profiles.change("setter", "4321") as u8, 2);
        assert_eq!(profiles.change("staubli", "x") as u8, 3);
        assert_eq!(profiles.active().name, "default");
        assert_eq!(profiles.change("setter", "1234") as u8, 0);
        assert_eq!(profiles.active().name, "setter");
    }

    #[test]
    fn the_manufacturer_stays() {
        let mut profiles = Profiles { active: profile("staubli", "x"), ..profiles() };
        assert_eq!(profiles.change("default", "") as u8, 4);
        assert_eq!(profiles.change("staubli", "x") as u8, 4);
        assert_eq!(profiles.active().name, "staubli");
    }
}
