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
