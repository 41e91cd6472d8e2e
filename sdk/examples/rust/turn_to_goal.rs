//! A policy in Rust, without any crate: action 1 turns left, 2 right, 0 goes straight on.
//! Build: rustc -O --crate-type cdylib turn_to_goal.rs -o turn-to-goal-rust.so
use std::ffi::CStr;
use std::os::raw::{c_char, c_void};
use std::ptr;

// The part of wend/abi.h that a policy needs; tables are size-prefixed, so later members need no mention.
#[repr(C)]
pub struct Host {
    size: u32,
    fail: extern "C" fn(*const Host, i32, *const c_char, *const c_char) -> i32,
}
#[repr(C)]
pub struct Column {
    low: f64,
    high: f64,
    count: u64,
    at: f64,
    name: *const c_char,
    unit: *const c_char,
}
#[repr(C)]
pub struct Space {
    size: u32,
    width: u32,
    columns: *const Column,
}
#[repr(C)]
pub struct Value {
    path: *const c_char,
    text: *const c_char,
    number: f64,
}
#[repr(C)]
pub struct Config {
    size: u32,
    copies: u32,
    robots: u32,
    value_count: u32,
    robot_value_count: u32,
    slot_count: u32,
    use_count: u32,
    values: *const Value,
    params: *const c_char,
    robot_values: *const Value,
    robot: *const c_char,
    slots: *const c_void,
    uses: *const c_void,
    seed: u64,
    observation: *const Space,
    action: *const Space,
}
#[repr(C)]
pub struct Policy {
    size: u32,
    begin: *const c_void,
    act: extern "C" fn(*mut Object, *const u32, u32, *const f64, *mut f64) -> i32,
}
#[repr(C)]
pub struct Component {
    size: u32,
    id: *const c_char,
    create: extern "C" fn(*const Host, *const Config, *mut *mut Object) -> i32,
    destroy: extern "C" fn(*mut Object),
    query: extern "C" fn(*mut Object, *const c_char) -> *const c_void,
}
#[repr(C)]
pub struct Plugin {
    size: u32,
    abi_major: u32,
    abi_minor: u32,
    component_count: u32,
    components: *const &'static Component,
}
unsafe impl Sync for Component {}
unsafe impl Sync for Plugin {}
unsafe impl Sync for Policy {}

pub struct Object {
    width: usize,
    bearing: usize,
    tolerance: f64,
}

const UNSUPPORTED: i32 = 3;

fn fail(host: *const Host, message: &'static str) -> i32 {
    unsafe { ((*host).fail)(host, UNSUPPORTED, ptr::null(), message.as_ptr() as *const c_char) }
}

extern "C" fn create(host: *const Host, config: *const Config, out: *mut *mut Object) -> i32 {
    unsafe { ptr::read_volatile(MANIFEST.as_ptr()) }; // what nothing refers to, the linker drops
    let config = unsafe { &*config };
    let observation = unsafe { &*config.observation };
    let columns = unsafe { std::slice::from_raw_parts(observation.columns, observation.width as usize) };
    let named = |c: &Column| unsafe { CStr::from_ptr(c.name) }.to_bytes() == b"goal.bearing";
    let bearing = match columns.iter().position(named) {
        Some(at) => at,
        None => return fail(host, "expected a column goal.bearing, found none\0"),
    };
    if unsafe { (*(*config.action).columns).count } < 3 {
        return fail(host, "expected at least 3 discrete actions\0");
    }
    let values = unsafe { std::slice::from_raw_parts(config.values, config.value_count as usize) };
    let given = values.iter().find(|v| unsafe { CStr::from_ptr(v.path) }.to_bytes() == b"tolerance");
    let tolerance = given.map_or(0.1, |v| v.number);
    unsafe { *out = Box::into_raw(Box::new(Object { width: columns.len(), bearing, tolerance })) };
    0
}

extern "C" fn destroy(object: *mut Object) {
    drop(unsafe { Box::from_raw(object) });
}

extern "C" fn act(object: *mut Object, _rows: *const u32, n: u32, observations: *const f64, actions: *mut f64) -> i32 {
    let me = unsafe { &*object };
    for i in 0..n as usize {
        unsafe {
            let bearing = *observations.add(i * me.width + me.bearing);
            *actions.add(i) = if bearing > me.tolerance { 1.0 } else if bearing < -me.tolerance { 2.0 } else { 0.0 };
        }
    }
    0
}

static POLICY: Policy = Policy { size: std::mem::size_of::<Policy>() as u32, begin: ptr::null(), act };

extern "C" fn query(_object: *mut Object, id: *const c_char) -> *const c_void {
    match unsafe { CStr::from_ptr(id) }.to_bytes() {
        b"wend.policy/1" => &POLICY as *const Policy as *const c_void,
        _ => ptr::null(),
    }
}

static COMPONENT: Component = Component {
    size: std::mem::size_of::<Component>() as u32,
    id: b"example.turn_to_goal_rust\0".as_ptr() as *const c_char,
    create,
    destroy,
    query,
};
static COMPONENTS: [&Component; 1] = [&COMPONENT];

#[no_mangle]
#[allow(non_upper_case_globals)]
pub static wend_plugin_1: Plugin = Plugin {
    size: std::mem::size_of::<Plugin>() as u32,
    abi_major: 1,
    abi_minor: 0,
    component_count: 1,
    components: COMPONENTS.as_ptr(),
};

#[used]
#[link_section = ".wend.manifest"]
static MANIFEST: [u8; include_bytes!("manifest.json").len()] = *include_bytes!("manifest.json");
