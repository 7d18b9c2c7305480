"""Turns themselves: conversion, chains, differences, displacements, fits."""
