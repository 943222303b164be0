using RayTracer.Numerics;

namespace RayTracer.Sampling;

/// <summary>
/// Chooses a cell of a grid with a probability in proportion to its weight: a row, and then a column of it, by inversion, so that
/// neighbouring numbers choose neighbouring cells. Probabilities are whole multiples of 2⁻²⁴, as random numbers are, so that they are exactly those with which
/// cells are chosen; a cell of any weight has at least one such unit in its row.
/// </summary>
internal sealed unsafe class GridDistribution
{
    private const int Units = 1 << 24;
    private readonly int _columns;
    private readonly int _rows;

    // Probability of all rows before each one and of all rows; and of the columns of each row, in the same way.
    private readonly PinnedBuffer<float> _rowsUpTo;
    private readonly PinnedBuffer<float> _columnsUpTo;

    private readonly PinnedBuffer<uint> _rowGuides;
    private readonly PinnedBuffer<uint> _columnGuides;

    /// <summary>Makes the tables.</summary>
    /// <param name="columns">Number of columns.</param>
    /// <param name="rows">Number of rows.</param>
    /// <param name="weigh">Writes the weights of a row's cells, none below zero.</param>
    public GridDistribution(int columns, int rows, Action<int, double[]> weigh)
    {
        (_columns, _rows) = (columns, rows);
        _rowsUpTo = new(rows + 1);
        _columnsUpTo = new((columns + 1L) * rows);
        _rowGuides = new(rows + 1);
        _columnGuides = new((columns + 1L) * rows);
        double[] weights = new double[columns];
        double[] sums = new double[rows];
        for (int row = 0; row < rows; row++)
        {
            weigh(row, weights);
            long first = (columns + 1L) * row;
            sums[row] = Accumulate(weights, _columnsUpTo.Pointer + first, _columnGuides.Pointer + first);
        }

        Sum = Accumulate(sums, _rowsUpTo.Pointer, _rowGuides.Pointer);
    }

    /// <summary>The sum of all weights; where it is zero, no cell can be chosen.</summary>
    public double Sum { get; }

    /// <summary>Chooses.</summary>
    /// <param name="u">First number: chooses the column.</param>
    /// <param name="v">Second number: chooses the row.</param>
    /// <param name="column">The column.</param>
    /// <param name="row">The row.</param>
    /// <param name="restU">The first number's place within the column's range, from 0 up to 1: as random again.</param>
    /// <param name="restV">The second number's place within the row's range.</param>
    /// <param name="probability">The probability of the choice.</param>
    public void Choose(in FloatW u, in FloatW v, out UIntW column, out UIntW row, out FloatW restU, out FloatW restV, out FloatW probability)
    {
        Search(_rowsUpTo.Pointer, _rowGuides.Pointer, 0u, _rows, v, out row, out restV, out FloatW ofRow);
        Search(_columnsUpTo.Pointer, _columnGuides.Pointer, row * (uint)(_columns + 1), _columns, u, out column, out restU, out FloatW ofColumn);
        probability = ofRow * ofColumn;
    }

    /// <summary>The probability of a cell.</summary>
    public void Probability(in UIntW column, in UIntW row, out FloatW probability)
    {
        UIntW at = (row * (uint)(_columns + 1)) + column;
        FloatW.Gather(_rowsUpTo.Pointer, row, out FloatW rowFrom, out FloatW rowTo);
        FloatW.Gather(_columnsUpTo.Pointer, at, out FloatW columnFrom, out FloatW columnTo);
        probability = (rowTo - rowFrom) * (columnTo - columnFrom);
    }

    // The last entry that is not above u.
    private static void Search(float* table, uint* guides, UIntW first, int count, in FloatW u, out UIntW found, out FloatW rest, out FloatW width)
    {
        found = GuideTable.Find(table, guides, first, count, u);
        FloatW.Gather(table, first + found, out FloatW before, out FloatW after);
        width = after - before;

        // In the middle of the smallest steps of u, of which a cell may have but one.
        rest = FloatW.Min((u - before + (0.5f / Units)) / width, float.BitDecrement(1));
    }

    private static double Accumulate(double[] weights, float* upTo, uint* guides)
    {
        double sum = 0;
        int count = 0;
        int last = weights.Length - 1;
        for (int i = 0; i < weights.Length; i++)
        {
            if (weights[i] > 0)
            {
                sum += weights[i];
                count++;
                last = i;
            }
        }

        // One unit for each cell with a weight, and the rest by weight.
        double scale = sum > 0 ? (Units - count) / sum : 0;
        double before = 0;
        int seen = 0;
        upTo[0] = 0;
        for (int i = 0; i < weights.Length; i++)
        {
            before += weights[i];
            seen += weights[i] > 0 ? 1 : 0;
            upTo[i + 1] = i >= last ? 1 : (float)((seen + double.Floor(before * scale)) / Units);
        }

        GuideTable.Fill(upTo, weights.Length, guides);
        return sum;
    }
}
