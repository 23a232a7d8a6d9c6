// SPDX-License-Identifier: MIT
#include "sandbox/main/failure.hpp"

#include "sandbox/report.hpp"

#include <cerrno>
#include <cstring>
#include <sys/socket.h>
#include <unistd.h>

namespace rigor::confine {

namespace {

void attach(msghdr& message, char* buffer, std::size_t size, int descriptor)
{
    message.msg_control = buffer;
    message.msg_controllen = size;
    cmsghdr* attached = CMSG_FIRSTHDR(&message);
    attached->cmsg_level = SOL_SOCKET;
    attached->cmsg_type = SCM_RIGHTS;
    attached->cmsg_len = CMSG_LEN(sizeof descriptor);
    std::memcpy(CMSG_DATA(attached), &descriptor, sizeof descriptor);
}

bool send(const Report& report, int descriptor)
{
    iovec bytes = {const_cast<Report*>(&report), sizeof report};
    msghdr message = {};
    message.msg_iov = &bytes;
    message.msg_iovlen = 1;
    alignas(cmsghdr) char buffer[CMSG_SPACE(sizeof descriptor)] = {};
    if (descriptor >= 0) attach(message, buffer, sizeof buffer, descriptor);
    return sendmsg(report_socket, &message, MSG_NOSIGNAL) >= 0;
}

} // namespace

void fail(const std::string& action)
{
    Report report = {errno, {}};
    std::strncpy(report.action, action.c_str(), sizeof report.action - 1);
    if (report_socket >= 0) send(report, -1);
    _exit(not_started);
}

void report_ready(int listener)
{
    if (!send(Report{}, listener)) _exit(not_started);
}

} // namespace rigor::confine
