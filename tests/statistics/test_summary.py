import numpy as np

from repro.statistics.summary import mean, standard_deviation


def test_spread_and_mean_of_a_table_with_an_infinite_value_are_infinite() -> None:
    tables = np.array([[1.0, 2.0, np.inf], [np.inf, np.inf, np.inf], [1.0, 2.0, 3.0]])

    assert standard_deviation(tables).tolist() == [np.inf, np.inf, 1.0]
    assert mean(tables).tolist() == [np.inf, np.inf, 2.0]
