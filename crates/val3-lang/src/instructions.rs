//! The instruction catalogue: every instruction, its forms and its page.
//!
//! An instruction is one file in the folder of its family and one line here.

use std::sync::LazyLock;

use rustc_hash::FxHashMap;

use crate::declare::catalogue;
use crate::instruction::{Family, Instruction, Overload};

catalogue! {
    variables {
        size,
        is_defined,
        insert,
        delete,
        get_data,
        append,
        resize,
        first,
        next,
        last,
        prev,
    }
    numbers {
        sin,
        asin,
        cos,
        acos,
        tan,
        atan,
        abs,
        sqrt,
        exp,
        power,
        ln,
        log,
        round_up,
        round_down,
        round,
        min,
        max,
        limit,
        sel,
    }
    bits {
        b_not,
        b_and,
        b_or,
        b_xor,
        to_binary,
        from_binary,
    }
    strings {
        to_string,
        to_num,
        chr,
        asc,
        left,
        right,
        mid,
        replace,
        find,
        len,
    }
    io {
        dio_link,
        dio_get,
        dio_set,
        io_status,
        aio_link,
        aio_get,
        aio_set,
        sio_link,
        clear_buffer,
        sio_get,
        sio_set,
        sio_ctrl,
    }
    screen {
        user_page,
        gotoxy,
        cls,
        set_text_mode,
        get_display_len,
        put,
        putln,
        title,
        get,
        get_key,
        is_key_pressed,
        pop_up_msg,
        log_msg,
        get_profile,
        set_profile,
        get_language,
        set_language,
        get_date,
    }
    tasks {
        task_suspend,
        task_resume,
        task_kill,
        set_mutex,
        help,
        task_status,
        task_create,
        task_create_sync,
        wait,
        delay,
        clock,
        watch,
    }
    libraries {
        lib_load,
        lib_save,
        lib_delete,
        lib_path,
        lib_list,
        lib_exist,
    }
    controller {
        disable_power,
        enable_power,
        is_powered,
        is_calibrated,
        working_mode,
        es_status,
        safety_fault,
        io_bus_status,
        get_monitor_speed,
        set_monitor_speed,
        get_version,
    }
    geometry {
        herej,
        is_in_range,
        set_latch,
        get_latch,
        distance,
        interpolate_l,
        interpolate_c,
        align,
        set_frame,
        position,
        link,
        open,
        close,
        compose,
        appro,
        here,
        joint_to_point,
        point_to_joint,
        config,
    }
    motion {
        movej,
        movel,
        movec,
        stop_move,
        reset_motion,
        restart_move,
        wait_end_move,
        is_empty,
        is_settled,
        auto_connect_move,
        get_speed,
        get_position_err,
        get_joint_force,
        get_move_id,
        set_move_id,
    }
    options {
        movejf,
        movelf,
        is_compliant,
        alter_movej,
        alter_movel,
        alter_movec,
        alter_begin,
        alter_end,
        alter,
        alter_stop_time,
        get_licence,
        get_dh,
        get_default_dh,
        set_dh,
        reset_turn,
    }
    additions {
        user_page_set,
        user_page_alert,
        user_page_confirm,
        user_page_prompt,
        opcua_export,
        set_safety_restart,
        get_jnt_ref,
        get_safe_ref_status,
        wake_up_robot,
        has_cpu_ext_power_supply,
        set_payload,
        speed_scale,
    }
    add_ons {
        file_open,
        file_close,
        file_get,
        file_set,
        file_exists,
        copy,
        delete,
        rename,
        exec,
        compile,
        dins,
        ddel,
        jog_context,
        jog_page,
        lib_open,
        lib_close,
        task_call_stack,
        get_name,
        circle_find,
        get_free_space,
        get_power_count,
        get_state,
        set_arm_limits,
        get_pos_fbk,
        get_jnt_fbk,
        get_jnt_speed_cmd,
        get_jnt_speed_fbk,
        rot_angle,
        get_rot,
        set_rot,
        get_cycle_time,
        get_boxcar_delay,
        motion_state,
        compute_jnt_frc,
        external_force,
        vel_frame,
        vel_tool,
        vel_joint,
        set_vel_cmd,
        rec_add,
        rec_clean,
        rec_start,
        rec_stop,
        rec_store,
    }
}

static BY_NAME: LazyLock<FxHashMap<&'static str, &'static Instruction>> =
    LazyLock::new(|| CATALOGUE.iter().map(|instruction| (instruction.name, *instruction)).collect());

/// Every instruction, family by family in the manual's order.
#[must_use]
pub fn all() -> &'static [&'static Instruction] {
    CATALOGUE
}

/// The instruction with this name, `$` included for those of add-ons.
#[must_use]
pub fn find(name: &str) -> Option<&'static Instruction> {
    BY_NAME.get(name).copied()
}

/// Loads a library under an identifier: the analysis compares the library with the identifier's interface (6.7).
pub const LIB_LOAD: &str = "libLoad";

/// Instructions that name a task of the same application or library (5.10).
pub const ON_TASKS: [&str; 4] = ["taskSuspend", "taskResume", TASK_KILL, TASK_STATUS];

/// Ends a task and takes its name away (5.10).
pub const TASK_KILL: &str = "taskKill";

/// Gives the state of a task: a number of its own, or that of a run-time error (5.10).
pub const TASK_STATUS: &str = "taskStatus";

/// Explains a run-time error, given by its number (5.10).
pub const HELP: &str = "help";

/// Instructions that give the code of a key (4.3).
pub const READ_KEYS: [&str; 2] = ["get", GET_KEY];

/// Takes the code of a key as its last argument (4.3).
pub const IS_KEY_PRESSED: &str = "isKeyPressed";

/// Reads data by its name, given as a text (2.5.4): what it names is used.
pub const GET_DATA: &str = "getData";

/// Changes an attribute of an element of a user page (s8): its page and id are texts.
pub const USER_PAGE_SET: &str = "userPageSet";

/// Tells whether a library has an item (6.7): a guard before its use.
pub const LIB_EXIST: &str = "libExist";

/// Tells the time (5.10): a loop that asks it paces itself.
pub const CLOCK: &str = "clock";

/// Waits until the arm has made every recorded move (10.6).
pub const WAIT_END_MOVE: &str = "waitEndMove";

/// Lets other tasks go on until a condition holds (5.10).
pub const WAIT: &str = "wait";

/// As [`WAIT`], for a limited time; returns whether the condition held (5.10).
pub const WATCH: &str = "watch";

/// Lets other tasks go on for a time, with 0 until their turns are over (5.10).
pub const DELAY: &str = "delay";

/// Changes the reference of its first argument, although the manual does not mark it as passed by reference (9.4.4,
/// 9.5.4, 9.6.3).
pub const LINK: &str = "link";

/// Tells whether a variable or element exists (2.5.4): a guard before its use.
pub const IS_DEFINED: &str = "isDefined";

/// The current move and its progress (10.6): a number that grows in steps of any size.
pub const GET_MOVE_ID: &str = "getMoveId";

/// The last key that was struck since it was asked before, or -1 (4.3).
pub const GET_KEY: &str = "getKey";

/// Arms the latch of the arm's position (9.2.3).
pub const SET_LATCH: &str = "setLatch";

/// Reads the latched position (9.2.3): the one before until the latch is armed.
pub const GET_LATCH: &str = "getLatch";

/// Waits for a flag that tasks share and takes it, within one line (5.9).
pub const SET_MUTEX: &str = "setMutex";

/// Writes a number in binary to an array of outputs (3.5.3).
pub const DIO_SET: &str = "dioSet";

/// Writes numerical outputs.
pub const AIO_SET: &str = "aioSet";

/// Encodes numbers as bytes (3.3.3): values, their number, format, bytes.
pub const TO_BINARY: &str = "toBinary";

/// Decodes numbers from bytes (3.3.3): bytes, their number, format, values.
pub const FROM_BINARY: &str = "fromBinary";

/// Changes a parameter of a serial line or socket (3.7.3).
pub const SIO_CTRL: &str = "sioCtrl";

/// Changes one dimension of an array (2.5.5): the array, the dimension, the size.
pub const RESIZE: &str = "resize";

/// The number of values of an array.
pub const SIZE: &str = "size";

/// Cancels the recorded moves.
pub const RESET_MOTION: &str = "resetMotion";

/// Switches the power of the arm off.
pub const DISABLE_POWER: &str = "disablePower";

/// A move on a circle.
pub const MOVEC: &str = "movec";

/// A move on a circle that a program may deviate.
pub const ALTER_MOVEC: &str = "alterMovec";

/// Computes a frame from three points.
pub const SET_FRAME: &str = "setFrame";

/// Sets the title of a user page.
pub const TITLE: &str = "title";

/// Instructions that write the output of a tool.
pub const ON_GRIPPERS: [&str; 2] = ["open", "close"];

/// Raises a number to a power (3.2.3): the base, the exponent.
pub const POWER: &str = "power";

/// Changes the size of an array (2.5.4, 2.5.5): none of them takes a local array.
const RESIZING: [&str; 4] = ["insert", "delete", "append", RESIZE];

/// The instruction changes the size of the array it is given.
#[must_use]
pub fn resizes(name: &str) -> bool {
    RESIZING.contains(&name)
}

/// The instruction may change the size of a container that it is given: those above, and those that make a global
/// array large enough for their result (6.7, 8.1). The effect of add-ons is not known.
#[must_use]
pub fn may_resize(instruction: &Instruction) -> bool {
    resizes(instruction.name)
        || matches!(instruction.name, "libList" | "ioBusStatus")
        || matches!(instruction.family, Family::AddOns | Family::Additions)
}

/// The call shows a page made with HTML (s8), which names data and programs of the application on its own.
#[must_use]
pub fn shows_named_page(instruction: &Instruction, form: &Overload) -> bool {
    instruction.name == "userPage" && form.since.is_some()
}

/// The instruction adds values to a collection or removes them, by their keys (2.5.4); the others that change sizes
/// take arrays alone.
#[must_use]
pub fn resizes_collections(name: &str) -> bool {
    matches!(name, "insert" | "delete")
}

/// The key at which the instruction looks need not be that of a value (2.5.4, 2.5.6).
#[must_use]
pub fn takes_any_key(name: &str) -> bool {
    matches!(name, IS_DEFINED | "next" | "prev")
}

/// The instruction yields a point in the frame that it is given (9.6.3).
#[must_use]
pub fn gives_point_in_frame(name: &str) -> bool {
    matches!(name, "here" | "jointToPoint")
}

/// The instruction changes the size of an array of two or three dimensions as well (2.5.5).
#[must_use]
pub fn resizes_every_array(name: &str) -> bool {
    name == RESIZE
}

#[cfg(test)]
mod tests {
    use super::{CATALOGUE, DELAY, LINK, TASK_STATUS, WAIT, find};
    use crate::instruction::Availability;
    use crate::keywords::is_task_creation;

    /// Instructions that the compiler turns into operations, because their arguments are evaluated repeatedly or are a
    /// call.
    fn is_compiled(name: &str) -> bool {
        is_task_creation(name) || [WAIT, "watch"].contains(&name)
    }

    fn lacks_handlers(name: &str) -> bool {
        find(name).unwrap().overloads.iter().any(|form| form.run.is_none())
    }

    #[test]
    fn no_handler_is_forgotten() {
        let forgotten: Vec<_> = CATALOGUE
            .iter()
            .filter(|row| row.availability == Availability::Manual)
            .map(|row| row.name)
            .filter(|name| is_compiled(name) != lacks_handlers(name))
            .collect();
        assert_eq!(forgotten, [""; 0]);
        assert!([DELAY, TASK_STATUS, LINK].into_iter().all(|name| !lacks_handlers(name)));
    }
}
