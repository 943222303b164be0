namespace RayTracer.Repository.Tests.Testing;

/// <summary>p-values against the tables that textbooks print, and against sums where there is one.</summary>
public class PValuesTests
{
    [Theory]
    [InlineData(1.959964, 0.05)]
    [InlineData(-2.575829, 0.01)]
    [InlineData(3.290527, 0.001)]
    [InlineData(0, 1)]
    public void Normal_is_the_table_on_both_sides(double z, double p) => Assert.Equal(p, PValues.Normal(z), 7);

    [Theory]
    [InlineData(12.706, 1, 0.05)]
    [InlineData(2.131, 15, 0.05)]
    [InlineData(-2.947, 15, 0.01)]
    [InlineData(3.646, 30, 0.001)]
    public void Student_t_is_the_table_on_both_sides(double t, double freedom, double p) => Assert.Equal(1, PValues.StudentT(t, freedom) / p, 2e-3);

    [Theory]
    [InlineData(3.841, 1, 0.05)]
    [InlineData(18.307, 10, 0.05)]
    [InlineData(23.209, 10, 0.01)]
    [InlineData(124.342, 100, 0.05)]
    [InlineData(0, 5, 1)]
    public void Chi_squared_is_the_table_above_the_sum(double sum, double freedom, double p) => Assert.Equal(1, PValues.ChiSquared(sum, freedom) / p, 2e-3);

    // Levels of the error budget lie far out: Φ(−8) exp(−x/2) of χ² and 1 − t/√(t² + 2) of t, each with two degrees of freedom.
    [Fact]
    public void Tails_are_right_where_levels_lie()
    {
        Assert.Equal(1, PValues.Normal(8) / 1.2441921148543639e-15, 1e-6);
        Assert.Equal(1, PValues.ChiSquared(60, 2) / Math.Exp(-30), 1e-9);

        // 1 − t/r is 2/(r(r + t)) without cancellation.
        const double t = 1e4;
        double r = Math.Sqrt((t * t) + 2);
        Assert.Equal(1, PValues.StudentT(t, 2) / (2 / (r * (r + t))), 1e-6);
    }

    [Fact]
    public void Counts_are_compared_cell_by_cell()
    {
        // (5² + 2² + 3² + 0² + 4² + 6²) / 10
        Assert.Equal(PValues.ChiSquared(9, 5), PValues.ChiSquared([5, 8, 7, 10, 14, 16], [10, 10, 10, 10, 10, 10]), 12);
        Assert.Equal(PValues.ChiSquared(9, 3), PValues.ChiSquared([5, 8, 7, 10, 14, 16], [10, 10, 10, 10, 10, 10], estimated: 2), 12);
    }

    // Cells that expect 1, 2 and 3 count as one of 6, so 3 cells are left.
    [Fact]
    public void Cells_that_expect_little_are_put_together() =>
        Assert.Equal(PValues.ChiSquared((16.0 / 6) + (4.0 / 20), 1), PValues.ChiSquared([4, 3, 3, 18], [1, 2, 3, 20]), 12);

    [Fact]
    public void A_count_where_nothing_can_be_has_no_chance()
    {
        Assert.Equal(0, PValues.ChiSquared([1, 99], [0, 100]));
        Assert.True(PValues.ChiSquared([0, 40, 60], [0, 50, 50]) > 0.04);
    }

    [Theory]
    [InlineData(20, 0.3)]
    [InlineData(7, 0.5)]
    [InlineData(40, 0.02)]
    public void Binomial_is_twice_the_smaller_tail(int trials, double probability)
    {
        double[] terms = new double[trials + 1];
        double choices = 1;
        for (int k = 0; k <= trials; k++)
        {
            terms[k] = choices * Math.Pow(probability, k) * Math.Pow(1 - probability, trials - k);
            choices *= (trials - k) / (k + 1.0);
        }

        Assert.All(Enumerable.Range(0, trials + 1), k =>
        {
            double expected = Math.Min(1, 2 * Math.Min(terms.Take(k + 1).Sum(), terms.Skip(k).Sum()));
            Assert.Equal(1, PValues.Binomial(k, trials, probability) / expected, 1e-9);
        });
    }

    [Fact]
    public void Binomial_of_certainty_allows_nothing_else()
    {
        Assert.Equal([1, 0, 1, 0], [PValues.Binomial(0, 9, 0), PValues.Binomial(1, 9, 0), PValues.Binomial(9, 9, 1), PValues.Binomial(8, 9, 1)]);
    }

    // Eight times 2 and eight times 0: sample variance 16/15, so the deviation of the mean of 16 is 1/√15.
    [Fact]
    public void A_mean_is_tested_by_its_own_spread()
    {
        double[] values = [.. Enumerable.Range(0, 16).Select(i => i % 2 == 0 ? 2.0 : 0.0)];
        double deviation = 1 / Math.Sqrt(15);
        Assert.Equal(PValues.StudentT(0.5 / deviation, 15), PValues.Mean(values, 0.5), 12);
        Assert.Equal(PValues.StudentT(0.3 / deviation, 15), PValues.Mean(values, 0.5, tolerance: 0.2), 12);
        Assert.Equal(1, PValues.Mean(values, 0.5, tolerance: 0.6));
        Assert.Equal(0, PValues.Mean([3, 3, 3], 3.1));
    }

    [Fact]
    public void The_smallest_of_several_is_multiplied_by_their_number()
    {
        Assert.Equal(0.06, PValues.Smallest([0.5, 0.02, 0.9]), 12);
        Assert.Equal(1, PValues.Smallest([0.5, 0.6, 0.9]));
        Assert.True(double.IsNaN(PValues.Smallest([0.5, double.NaN, 0.9])));
    }
}
