"""Cases that random searches found to be the worst: nearest to their bounds, or of the largest error."""

from typing import Any

BODIES: list[tuple[Any, ...]] = [
    (
        "shape",
        "quarter disk, found",
        "found by search: the centroid's bound is met to 70 %",
        {"shape": "quarter-disk", "radius": 9703.733348186683, "mass": 727.5401014875604},
    ),
    (
        "shape",
        "quarter-circle rod, found",
        "found by search: the centroid's bound is met to 68 %",
        {"shape": "quarter-circle-rod", "radius": 26906.1523656567, "mass": 19.947921328338463},
    ),
    (
        "shape",
        "long half shell, found",
        "found by search: 2e4 radii long, and the centroid's bound is met to 73 %",
        {
            "shape": "half-cylindrical-shell",
            "radius": 0.8202182515281675,
            "length": 16683.63993236113,
            "mass": 26.039335559876413,
        },
    ),
    (
        "body",
        "two parts, mass, found",
        "found by search: the rounding of a sum of masses comes to 98 % of its bound",
        {
            "parts": [
                {
                    "position": [0.0, 0.0, 0.0],
                    "euler_angles": [-2.3430682362338437, -0.933, -2.0422468518369152],
                    "euler_order": "xyz",
                    "mass": 1.1643663035928524,
                },
                {
                    "position": [4052.511054575705, -7716.187, -3133.150574428041],
                    "quaternion": [-0.7824766151091733, 0.02, 0.21129728006803306, -0.958],
                    "mass": 2.903,
                },
            ]
        },
    ),
    (
        "body",
        "one part far off, found",
        "found by search: the centroid's bound is met to 90 %",
        {
            "parts": [
                {
                    "position": [-1245.615, 8618.636865561592, -2663.145],
                    "euler_angles": [-0.5704635449897779, 0.39285789698500295, 1.215],
                    "euler_order": "xyz",
                    "mass": 3.0621830054289245,
                    "shape": "semicircle-rod",
                    "radius": 1.4946521680436942,
                }
            ]
        },
    ),
    (
        "tensor",
        "needle's tensor 1, found",
        "found by search: the least moment is off by 1229 roundings, half of the bound",
        {
            "tensor": [
                [0.016474062949383347, -0.0007957162328007584, -0.0016571489000649345],
                [-0.0007957162328007584, 0.013577110750755293, -0.006427774617860397],
                [-0.0016571489000649345, -0.006427774617860397, 0.0033078146804831512],
            ]
        },
    ),
    (
        "tensor",
        "needle's tensor 2, found",
        "found by search: the least moment is off by 28104 roundings, half of the bound",
        {
            "tensor": [
                [0.18062636781550992, -0.1497083131936845, 0.029110985671535267],
                [-0.1497083131936845, 0.13537171136774007, 0.03384776735734052],
                [0.029110985671535267, 0.03384776735734052, 0.302828670116279],
            ]
        },
    ),
    (
        "tensor",
        "needle's tensor 3, found",
        "found by search: the least moment is off by 4248 roundings, half of the bound",
        {
            "tensor": [
                [0.0048617918086211465, 3.246949796175264e-05, -0.0026033164524994034],
                [3.246949796175264e-05, 0.006256670463412109, 6.028427308147332e-05],
                [-0.0026033164524994034, 6.028427308147332e-05, 0.0013964208932850043],
            ]
        },
    ),
    (
        "torque",
        "slow spin, found",
        "found by search: the bound of a component of the torque is met to 72 %",
        {
            "tensor": [
                [0.0009655837575599106, -7.863611315690573e-05, 8.747280817150067e-05],
                [-7.863611315690573e-05, 0.0005460325513532346, 0.0004776284537766165],
                [8.747280817150067e-05, 0.0004776284537766165, 0.0004483367374997174],
            ],
            "angular_velocity": [0.043194388748811485, -0.001593635001042574, -0.9516194080252386],
            "angular_acceleration": [131.56284369960068, 9.835824774492348, 0.9837779399881355],
        },
    ),
    (
        "torque",
        "fast about one axis, found",
        "found by search: the bound of the energy is met to 69 %",
        {
            "tensor": [
                [0.49590050138509034, 0.3544026649419771, 0.22129122079588],
                [0.3544026649419771, 0.49113723067374754, -0.22278234730297192],
                [0.22129122079588, -0.22278234730297192, 0.7088243408513751],
            ],
            "angular_velocity": [0.10905260964970818, -32.90966815686199, 0.007901752313897899],
            "angular_acceleration": [0.00809656737861137, 0.0046660396718328345, 147.0956120040163],
        },
    ),
    (
        "compare",
        "nudged by less than rounding, found",
        "found by search: all elements of the tensors agree to the bit, and the distance between them is no zero",
        {
            "first": {
                "parts": [
                    {
                        "position": [0.0, 0.0, 0.0],
                        "rotation_axis": [-0.384, -0.085, -0.4450269332338901],
                        "rotation_angle": -2.328203618137052,
                        "mass": 1.405,
                        "shape": "hemisphere",
                        "radius": 418.62831110654486,
                    },
                    {
                        "position": [0.859, -0.801, -0.620907593483816],
                        "quaternion": [-0.629, -0.729, 0.101, 0.6169863912987577],
                        "mass": 3.038783835479212,
                        "shape": "hollow-block",
                        "width": 1.2638480923484043,
                        "depth": 337313.6964642074,
                        "height": 2.1694732261857194e-06,
                        "thickness": 6.920880313082436e-17,
                    },
                    {
                        "position": [-0.8459260028951718, 0.46466220560015636, -0.983],
                        "mass": 0.471,
                        "shape": "paraboloid",
                        "radius": 0.0007604333792996781,
                        "height": 0.538,
                    },
                ]
            },
            "second": {
                "parts": [
                    {
                        "position": [3.906928398034075e-10, 0.0, 0.0],
                        "rotation_axis": [-0.384, -0.085, -0.4450269332338901],
                        "rotation_angle": -2.328203618137052,
                        "mass": 1.405,
                        "shape": "hemisphere",
                        "radius": 418.62831110654486,
                    },
                    {
                        "position": [0.859, -0.801, -0.620907593483816],
                        "quaternion": [-0.629, -0.729, 0.101, 0.6169863912987577],
                        "mass": 3.038783835479212,
                        "shape": "hollow-block",
                        "width": 1.2638480923484043,
                        "depth": 337313.6964642074,
                        "height": 2.1694732261857194e-06,
                        "thickness": 6.920880313082436e-17,
                    },
                    {
                        "position": [-0.8459260028951718, 0.46466220560015636, -0.983],
                        "mass": 0.471,
                        "shape": "paraboloid",
                        "radius": 0.0007604333792996781,
                        "height": 0.538,
                    },
                ]
            },
        },
    ),
]

MESHES: list[tuple[Any, ...]] = [
    (
        "box blade, found",
        "found by search: five roundings of a volume of twelve triangles, which do not average out",
        {
            "solid": "box",
            "stretch": [1.8273139386240877e-05, 0.05453586694185509, 1.0],
            "quaternion": [-0.9076302927043105, -0.9003333886203664, -0.034374088426045724, -0.9339778146974902],
            "offset": [0.0, -0.0, 133.44133197057243],
            "single": False,
            "shell": False,
        },
    ),
    (
        "box needle, single, found",
        "found by search: a product of inertia by the tilt of axes that are orthogonal to rounding only",
        {
            "solid": "box",
            "stretch": [1.0, 4.6223576953512386e-07, 2.891274337532292e-06],
            "quaternion": [0.6863105063274979, -0.0361856094732671, -0.5442489407958062, -0.4198027978670531],
            "offset": [0.0, 80.14467975742545, 0.0],
            "single": True,
            "shell": False,
        },
    ),
    (
        "ball needle at 4e6 sizes, found",
        "found by search: a product of inertia at 97 % of its bound",
        {
            "solid": "ball 1",
            "stretch": [1.990596817009261e-06, 5.854008010074182e-07, 1.0],
            "quaternion": [0.49380848465676985, -0.18007719445894943, -0.8946720212257808, -0.7681651716361957],
            "offset": [4021390.0032832813, 34.48116511118696, -302090.06680219737],
            "single": False,
            "shell": False,
        },
    ),
    (
        "box needle, found",
        "found by search: a product of inertia at 95 % of its bound",
        {
            "solid": "box",
            "stretch": [0.0007831481077990681, 1.0, 0.00038877513257433075],
            "quaternion": [0.7610908805360634, 0.6438002115239909, -0.06820901655291589, -0.4069016614587797],
            "offset": [0.0, 0.0, 0.0],
            "single": False,
            "shell": False,
        },
    ),
    (
        "ball blade at 1e5 sizes, found",
        "found by search: a product of inertia at 93 % of its bound",
        {
            "solid": "ball 1",
            "stretch": [0.00351461688419522, 1.3555898338781822e-06, 1.0],
            "quaternion": [0.27496371517512874, -0.1555420534339167, 0.5086631075755315, 0.8968513618891352],
            "offset": [159642.2058895104, 8.998418587337868, -0.0],
            "single": False,
            "shell": False,
        },
    ),
    (
        "tetrahedron at 2e5 sizes, found",
        "found by search: few large faces and a product of inertia at 93 % of its bound",
        {
            "solid": "tetrahedron",
            "stretch": [0.0014179293716578565, 1.0, 4.32934809435504e-05],
            "quaternion": [0.1598549755095744, 0.6938785535152932, 0.7940413215440936, -0.41480152299881135],
            "offset": [-297.8288544288074, 188639.27216400523, -0.0],
            "single": False,
            "shell": False,
        },
    ),
    (
        "shell of ball blade, found",
        "found by search: eight roundings of a shell's moments by axes stretched by rounding",
        {
            "solid": "ball 2",
            "stretch": [1.0, 2.2255217350852532e-05, 0.002176045237465923],
            "quaternion": [-0.5192473547765513, 0.37045636917953084, 0.17259227849162362, -0.6141403440111539],
            "offset": [-0.0, 0.0, -5174.452474599214],
            "single": False,
            "shell": True,
        },
    ),
    (
        "shell of bracket, found",
        "found by search: eight roundings of a shell's moments, and slivers among its faces",
        {
            "solid": "bracket",
            "stretch": [1.0, 6.604488010958044e-06, 0.0003517506737975516],
            "quaternion": [0.04344764669518009, 0.1278405471392241, -0.6741974349185214, -0.2261338612757149],
            "offset": [0.0, 0.0, 42.24204502393818],
            "single": False,
            "shell": True,
        },
    ),
]

SECTIONS: list[tuple[Any, ...]] = [
    (
        "bore in a thin tube, found",
        "found by search: two roundings of the sum of both circles' lengths",
        {
            "pieces": [{"diameter": 0.020483302338842428, "x": 424321110.59694946, "y": -0.0}],
            "holes": [{"diameter": 0.020483302289505182, "x": 424321110.59694946, "y": -0.0}],
        },
    ),
    (
        "strip at 1e7 sizes, found",
        "found by search: an area is rounded by half of its last bit",
        {
            "polygon": [
                14776142.075550139,
                -4.426970994944079,
                14776142.675550139,
                -3.626970994944079,
                14776142.675550114,
                -3.6269709775485106,
                14776142.075550115,
                -4.42697097754851,
            ]
        },
    ),
]

MATRICES: list[tuple[Any, ...]] = [
    (
        "met bound, found",
        "found by search: three roundings of the greatest eigenvalue, a third of its bound",
        [
            [1.1929499609751697e-07, -4.2150570615346264e-13, -1.7807009282465333e-09],
            [-4.2150570615346264e-13, 5.814588966039586e-12, 6.294271921869157e-12],
            [-1.7807009282465333e-09, 6.294271921869157e-12, 5.181502564376837e-10],
        ],
    ),
    (
        "worst error, found",
        "found by search: graded and nearly singular when scaled, which costs the least eigenvalue four digits",
        [
            [1.0487640484651527e-13, -1.1017469169501026e-11, -1.7012616537466988e-13],
            [-1.1017469169501026e-11, 1.3986595522455167e-09, -9.147568902870665e-11],
            [-1.7012616537466988e-13, -9.147568902870665e-11, 4.992335918195668e-11],
        ],
    ),
    (
        "second worst error, found",
        "found by search: graded and nearly singular when scaled, which costs the least eigenvalue three digits",
        [
            [1.3091072592751646e-07, 3.694546681325849e-11, -2.0547623892431585e-12],
            [3.694546681325849e-11, 3.1493780312866374e-12, 1.0499703639321672e-13],
            [-2.0547623892431585e-12, 1.0499703639321672e-13, 3.586019507023287e-15],
        ],
    ),
    (
        "loosest bound, found",
        "found by search: graded, and the least eigenvalue is what two smaller steps leave of a difference",
        [
            [0.004150457788664302, -6.02157529288693e-13, -3.229162386288555e-09],
            [-6.02157529288693e-13, 8.923830971123405e-23, 4.691929807693454e-19],
            [-3.229162386288555e-09, 4.691929807693454e-19, 2.5126319312952134e-15],
        ],
    ),
    (
        "eleven digits lost, found",
        "found by search: of the least eigenvalue Jacobi's rotations leave five digits, which one quotient gives back",
        [
            [6.087672541786929e-21, -8.959658082092769e-13, -4.8964547660478196e-20],
            [-8.959658082092769e-13, 0.00013186713113019077, 7.206477912550311e-12],
            [-4.8964547660478196e-20, 7.206477912550311e-12, 3.9383334216721947e-19],
        ],
    ),
]

OVERLAPPING: list[tuple[Any, ...]] = [
    (
        "ball needle, corners on three planes",
        "found by search: single precision at 4e6 sizes leaves corners on three planes, and faces that overlap",
        {
            "solid": "ball 1",
            "stretch": [0.0002345666186584428, 0.0013695727769151914, 1.0],
            "quaternion": [0.7858380146927861, 0.5173413854811701, -0.08357968938697091, -0.5658226635389025],
            "offset": [-0.0, -0.0, 4465692.083934343],
            "single": True,
            "shell": False,
        },
    ),
]
