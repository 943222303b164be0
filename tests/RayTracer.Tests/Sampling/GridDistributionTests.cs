using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Tests.Statistics;

namespace RayTracer.Tests.Sampling;

/// <summary>Choosing a cell of a grid.</summary>
[Trait("Category", "Thorough")]
public class GridDistributionTests
{
    private const int Columns = 13, Rows = 7;

    // Weights of many sizes; whole rows and single cells without any.
    private static readonly double[][] s_weights =
        [.. Enumerable.Range(0, Rows).Select(row => Enumerable.Range(0, Columns).Select(column => row == 3 || (row + column) % 5 == 0 ? 0 : Math.Pow(1 + column, row)).ToArray())];

    private static readonly GridDistribution s_grid = new(Columns, Rows, (row, weights) => s_weights[row].CopyTo(weights, 0));

    [Fact]
    public void Probabilities_are_those_of_the_weights_and_their_sum_is_1_exactly()
    {
        double sum = s_weights.Sum(row => row.Sum());
        double all = 0;
        for (uint row = 0; row < Rows; row++)
        {
            for (uint column = 0; column < Columns; column++)
            {
                s_grid.Probability(column, row, out FloatW probability);
                double expected = s_weights[row][column] / sum;
                Assert.Equal(expected, probability[0], 2e-6);
                Assert.Equal(expected > 0, probability[0] > 0);
                all += probability[0];
            }
        }

        Assert.Equal(1, all, 1e-7);
        Assert.Equal(sum, s_grid.Sum, sum * 1e-12);
    }

    [Fact]
    public void Cells_are_chosen_with_their_probabilities_and_what_is_left_of_the_numbers_is_uniform()
    {
        double[] counts = new double[Columns * Rows];
        double[] expected = new double[Columns * Rows];
        UnitSquareCounts rests = new();
        int samples = TestSettings.Scale(1 << 17, 1 << 21);
        UnitSquare.AtRandom(samples, (u, v, lane) =>
        {
            s_grid.Choose(u, v, out UIntW column, out UIntW row, out FloatW restU, out FloatW restV, out FloatW probability);
            int cell = ((int)row[lane] * Columns) + (int)column[lane];
            counts[cell]++;
            expected[cell] = probability[lane] * (double)samples;
            rests.Add(restU[lane], restV[lane]);
        });
        for (int i = 0; i < counts.Length; i++)
        {
            s_grid.Probability((uint)(i % Columns), (uint)(i / Columns), out FloatW probability);
            Assert.True(counts[i] == 0 || Math.Abs(expected[i] - (probability[0] * (double)samples)) < 1e-3 * expected[i]);
            expected[i] = probability[0] * (double)samples;
        }

        ErrorBudget.Warps.Check(PValues.ChiSquared(counts, expected), "cells of a grid");
        ErrorBudget.Warps.Check(rests.P(), "what is left of the numbers that choose cells");
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(7)]
    [InlineData(64)]
    [InlineData(1000)]
    public void A_number_chooses_the_last_cell_that_does_not_begin_above_it(int columns)
    {
        // A sun, a faint sky, and gaps without light.
        GridDistribution grid = new(columns, 1, (_, weights) =>
        {
            for (int i = 0; i < columns; i++)
            {
                weights[i] = i == columns / 3 ? 1000 : i % 5 == 4 ? 0 : 1 + (i % 3);
            }
        });
        float begin = 0;
        for (uint cell = 0; cell < columns; cell++)
        {
            grid.Probability(cell, 0u, out FloatW probability);
            float end = begin + probability[0];
            if (end > begin)
            {
                foreach (float u in new[] { begin, float.BitIncrement(begin), (begin + end) / 2, float.BitDecrement(end) })
                {
                    // A number in other lanes does not disturb it.
                    FloatW numbers = (UIntW.Iota & 1u).ToFloat() * 0.75f;
                    numbers = MaskW.First(1).Select(u, numbers);
                    grid.Choose(numbers, 0.5f, out UIntW column, out _, out _, out _, out _);
                    Assert.Equal(cell, column[0]);
                }
            }

            begin = end;
        }

        Assert.Equal(1, begin);
    }

    [Fact]
    public void What_is_no_number_chooses_some_cell()
    {
        s_grid.Choose(float.NaN, float.PositiveInfinity, out UIntW column, out UIntW row, out _, out _, out _);
        Assert.True(column[0] < Columns && row[0] < Rows);
    }

    [Fact]
    public void The_faintest_cell_beside_the_brightest_can_be_chosen()
    {
        GridDistribution grid = new(3, 1, (_, weights) => (weights[0], weights[1], weights[2]) = (1e-30, 1, 1e-30));
        grid.Choose(0f, 0.5f, out UIntW first, out _, out FloatW rest, out _, out FloatW probability);
        Assert.Equal((0u, 0.5f), (first[0], rest[0]));
        Assert.True(probability[0] > 0);
        grid.Choose(float.BitDecrement(1), 0.5f, out UIntW last, out _, out _, out _, out _);
        Assert.Equal(2u, last[0]);
    }
}
