/* The first and only program of a small virtual machine: makes HID devices with uhid, sends their reports and prints what
 * the kernel's drivers make of them. Its input is /work.txt:
 *
 *     D NAME VENDOR PRODUCT DESCRIPTOR    a device; vendor and product decimal, the descriptor in hexadecimal
 *     R BYTES                             a report of it
 *
 * and its output, on the console, for each device: "D NAME", for each of its event nodes "N index name", "K code" for the
 * keys that matter, "A code min max resolution", "." ; then for each report "R" and the events "E node type code value".
 * "X why" says that a device could not be made. */
#include <dirent.h>
#include <fcntl.h>
#include <linux/input.h>
#include <linux/uhid.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/mount.h>
#include <sys/reboot.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/sysmacros.h>
#include <unistd.h>

enum { MAX_NODES = 16, LINE = 20000 };

static void load(const char* name) {
    char path[100];
    snprintf(path, sizeof path, "/modules/%s.ko", name);
    int fd = open(path, O_RDONLY);
    if (fd < 0 || syscall(SYS_finit_module, fd, "", 0) != 0) printf("X module %s\n", name);
    if (fd >= 0) close(fd);
}

static int bytes_of(const char* hex, unsigned char* out, int most) {
    int n = 0;
    unsigned value;
    while (n < most && sscanf(hex, "%2x", &value) == 1) {
        out[n++] = (unsigned char)value;
        hex += 2;
    }
    return n;
}

struct device {
    int uhid;
    int nodes[MAX_NODES];
    int count;
};

/* Answers what the driver asks, so that it does not wait. How many questions there were. */
static int answer(struct device* d, int wait_ms) {
    struct pollfd p = {d->uhid, POLLIN, 0};
    int questions = 0;
    while (poll(&p, 1, wait_ms) > 0) {
        struct uhid_event e, reply;
        if (read(d->uhid, &e, sizeof e) <= 0) return questions;
        questions++;
        memset(&reply, 0, sizeof reply);
        if (e.type == UHID_GET_REPORT) {
            reply.type = UHID_GET_REPORT_REPLY;
            reply.u.get_report_reply.id = e.u.get_report.id;
            reply.u.get_report_reply.err = 5;
            write(d->uhid, &reply, sizeof reply);
        } else if (e.type == UHID_SET_REPORT) {
            reply.type = UHID_SET_REPORT_REPLY;
            reply.u.set_report_reply.id = e.u.set_report.id;
            write(d->uhid, &reply, sizeof reply);
        }
        wait_ms = 0;
    }
    return questions;
}

static void describe(int index, int fd) {
    char name[200] = "?";
    unsigned char keys[96] = {0}, axes[8] = {0};
    ioctl(fd, EVIOCGNAME(sizeof name), name);
    ioctl(fd, EVIOCGBIT(EV_KEY, sizeof keys), keys);
    ioctl(fd, EVIOCGBIT(EV_ABS, sizeof axes), axes);
    printf("N %d %s\n", index, name);
    for (int k = BTN_TOOL_PEN; k <= BTN_TOOL_QUADTAP + 8; k++)
        if (keys[k / 8] >> (k % 8) & 1) printf("K %d\n", k);
    for (int a = 0; a < 64; a++) {
        struct input_absinfo info;
        if ((axes[a / 8] >> (a % 8) & 1) && ioctl(fd, EVIOCGABS(a), &info) >= 0)
            printf("A %d %d %d %d\n", a, info.minimum, info.maximum, info.resolution);
    }
    printf(".\n");
}

static void open_nodes(struct device* d) {
    d->count = 0;
    for (int i = 0; i < 64 && d->count < MAX_NODES; i++) {
        char path[40];
        snprintf(path, sizeof path, "/dev/input/event%d", i);
        int fd = open(path, O_RDONLY | O_NONBLOCK);
        if (fd < 0) continue;
        struct input_id id;
        if (ioctl(fd, EVIOCGID, &id) < 0 || id.bustype != BUS_USB) {
            close(fd);
            continue;
        }
        describe(d->count, fd);
        d->nodes[d->count++] = fd;
    }
}

static void close_device(struct device* d) {
    for (int i = 0; i < d->count; i++) close(d->nodes[i]);
    d->count = 0;
    if (d->uhid >= 0) close(d->uhid);
    d->uhid = -1;
    usleep(30000);
}

static void make_device(struct device* d, char* rest) {
    char name[128];
    unsigned vendor, product;
    int at = 0;
    close_device(d);
    if (sscanf(rest, "%120s %u %u %n", name, &vendor, &product, &at) != 3) return;
    printf("D %s\n", name);
    d->uhid = open("/dev/uhid", O_RDWR | O_CLOEXEC);
    struct uhid_event e;
    memset(&e, 0, sizeof e);
    e.type = UHID_CREATE2;
    snprintf((char*)e.u.create2.name, sizeof e.u.create2.name, "%s", name);
    e.u.create2.rd_size = (unsigned short)bytes_of(rest + at, e.u.create2.rd_data, (int)sizeof e.u.create2.rd_data);
    e.u.create2.bus = BUS_USB;
    e.u.create2.vendor = vendor;
    e.u.create2.product = product;
    if (d->uhid < 0 || write(d->uhid, &e, sizeof e) < 0) printf("X uhid\n");
    for (int quiet = 0, turn = 0; quiet < 8 && turn < 200; turn++) quiet = answer(d, 25) > 0 ? 0 : quiet + 1;
    open_nodes(d);
    answer(d, 5);
}

static void send_report(struct device* d, const char* hex) {
    struct uhid_event e;
    memset(&e, 0, sizeof e);
    e.type = UHID_INPUT2;
    e.u.input2.size = (unsigned short)bytes_of(hex, e.u.input2.data, (int)sizeof e.u.input2.data);
    printf("R\n");
    if (write(d->uhid, &e, sizeof e) < 0) printf("X input\n");
    for (int i = 0; i < d->count; i++) {
        struct input_event events[64];
        ssize_t n;
        while ((n = read(d->nodes[i], events, sizeof events)) > 0)
            for (size_t k = 0; k < (size_t)n / sizeof events[0]; k++)
                printf("E %d %d %d %d\n", i, events[k].type, events[k].code, events[k].value);
    }
}

int main(void) {
    static char line[LINE];
    mkdir("/proc", 0755), mkdir("/sys", 0755), mkdir("/dev", 0755);
    mount("proc", "/proc", "proc", 0, "");
    mount("sysfs", "/sys", "sysfs", 0, "");
    mount("devtmpfs", "/dev", "devtmpfs", 0, "");
    const char* modules[] = {"evdev",  "hid",   "usb-common",  "usbcore",       "usbhid",
                             "uhid",   "wacom", "hid-generic", "hid-multitouch"};
    for (size_t i = 0; i < sizeof modules / sizeof *modules; i++) load(modules[i]);
    FILE* work = fopen("/work.txt", "r");
    struct device d = {-1, {0}, 0};
    printf("BEGIN\n");
    while (work && fgets(line, sizeof line, work)) {
        line[strcspn(line, "\n")] = 0;
        if (line[0] == 'D') make_device(&d, line + 2);
        if (line[0] == 'R' && d.uhid >= 0) send_report(&d, line + 2);
    }
    close_device(&d);
    printf("END\n");
    fflush(stdout);
    sync();
    reboot(RB_POWER_OFF);
    return 0;
}
