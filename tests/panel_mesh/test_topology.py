import numpy as np

from swifttailor.panel_mesh.topology import component_count, topology


def test_known_surfaces():
    tetrahedron = np.array([[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]])
    sphere = topology(tetrahedron, 4)
    assert (sphere.components, sphere.boundary_loops, sphere.euler_characteristic) == (1, 0, 2)
    assert sphere.nonmanifold_edges == sphere.inconsistent_edges == 0
    open_box = topology(tetrahedron[:3], 4)
    assert (open_box.boundary_loops, open_box.euler_characteristic) == (1, 1)
    assert topology(np.array([[0, 1, 2], [0, 1, 3], [0, 1, 4]]), 5).nonmanifold_edges == 1
    assert topology(np.array([[0, 1, 2], [0, 1, 3]]), 4).inconsistent_edges == 1
    assert component_count(np.array([[0, 1, 2], [3, 4, 5]]), 7) == 3
