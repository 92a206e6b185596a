//! Known instructions of add-ons, so that a finding can name the add-on that a cell does not have.

/// Add-ons, best known first, with instruction names without `$`.
#[rustfmt::skip]
static PROVIDERS: [(&str, &str); 6] = [
    ("Expansion", "\
        applyImage busService circleFind compile copy ddel delete dins envelopeError exec fileClose \
        fileExists fileGet fileOpen fileSet getDateTime getFatherId getFreeSpace getGravity getJntFbk \
        getJoint getLink getMotMoveId getMoveIdVel getMoveType getName getPathContext getPoint getPosFbk \
        getPowerCount getSpeedCmd getSpeedFbk getState getTool jogContext jogj jogl jogPage libClose \
        libGetLoadMode libOpen libSetLoadMode listIos mkClonImage mkFullImage rand randn rename setArmLimits \
        setCellLimits setDateTime setenv setGravity setMaxJntForce setMaxPosErr setMjogLed setPathMode \
        stopMove taskCallStack updateFW waitEndMove wvEvent Xjogj Xjogl"),
    ("Velocity", "\
        setVelCmd velFrame velJoint velTool"),
    ("Motion", "\
        alterAtc coggingEnable coggingParams computeJntFrc drvGetAnswer drvSelect drvSendCommand \
        externalForce firFilter getBoxcarDelay getCycleTime getDrvFeedFwd getDrvForce getFeedForward \
        getInertia getJntFbk getJntPosRef getJntSpeedCmd getJntSpeedFbk getJntSpeedRef getLimits \
        getMotMoveId getMoveIdVel getMovejData getMoveltData getMoveType getPosFbk getRot getSpeedCmd \
        getSpeedFbk initFirFilter initFirFilter2 loadTraj motionState moveTraj readTraj rotAngle \
        setBoxcarFreq setCartJogAcc setFriction setInertia setMaxJointVel setMaxTvel setOffset setRot \
        setVelCmd stopMove velFrame velJoint velTool waitEndMove writeTraj"),
    ("Recorder", "\
        asmClean asmSave backlashClean backlashLoad backlashTest backlashUpdate gsmLoad gsmTest recAdd \
        recClean recGetVar recLoad recReadVar recSize recStart recStop recStore recVarList recWait \
        recWriteVar slotLoad slotTest vregTest"),
    ("Remote", "\
        calibrate jogContext jogj jogl recover setOffset unCalibrate Xjogj Xjogl"),
    ("Relbo", "\
        copy ddel delete dins enablePopups fileExists getDateTime getJoint getPoint getTool jogContext jogj \
        jogl libClose libOpen listIos recover rename setDateTime setMaxJntForce setMaxPosErr setOffset Xjogj \
        Xjogl"),
];

/// Add-ons that are known to contain the instruction, best known first; `name` includes `$`.
///
/// Empty for an instruction in an unknown add-on. The table of an installed add-on lists its actual instructions.
pub fn providers(name: &str) -> impl Iterator<Item = &'static str> {
    let name = name.strip_prefix('$').unwrap_or_default();
    PROVIDERS.iter().filter(move |(_, names)| names.split(' ').any(|known| known == name)).map(|(add_on, _)| *add_on)
}

#[cfg(test)]
mod tests {
    use super::{PROVIDERS, providers};
    use crate::instructions;

    #[test]
    fn several_add_ons_share_a_name() {
        assert_eq!(providers("$ddel").collect::<Vec<_>>(), ["Expansion", "Relbo"]);
        assert_eq!(providers("$velJoint").next(), Some("Velocity"));
        assert_eq!(providers("$").count() + providers("ddel").count() + providers("$nothing").count(), 0);
    }

    #[test]
    fn the_catalogue_names_a_provider() {
        for instruction in instructions::all() {
            if let Some(add_on) = instruction.add_on() {
                assert_eq!(providers(instruction.name).next(), Some(add_on), "{}", instruction.name);
            }
        }
        assert!(PROVIDERS.iter().all(|(_, names)| names.split(' ').all(|name| !name.is_empty())));
    }
}
