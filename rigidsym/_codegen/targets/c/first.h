#ifndef TORQUE_FREE_H
#define TORQUE_FREE_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif
