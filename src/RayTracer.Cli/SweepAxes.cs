using RayTracer.Imaging;
using RayTracer.Scenes;

namespace RayTracer.Cli;

/// <summary>
/// The values that <c>raytracer sweep</c> goes through: of the settings, those with several values, with commas between them.
/// </summary>
internal sealed class SweepAxes
{
    private const int Most = 3;

    private readonly List<SheetAxis> _axes = [];
    private readonly List<SceneSetting> _fixed = [];

    /// <summary>Separates axes from settings of one value.</summary>
    /// <exception cref="CommandException">There is no axis, or more than can be shown.</exception>
    public SweepAxes(IReadOnlyList<SceneSetting> settings)
    {
        foreach (SceneSetting setting in settings)
        {
            IReadOnlyList<string> values = Split(setting.Value);
            if (values.Count > 1)
            {
                _axes.Add(new(setting.Path, values));
            }
            else
            {
                _fixed.Add(setting);
            }
        }

        if (_axes.Count is 0 or > Most)
        {
            throw new CommandException(ExitStatus.Usage, _axes.Count == 0
                ? $"what should change? Give --set PATH=VALUE,VALUE,… with the values to try"
                : $"a sheet shows at most {Most} lists of values: as columns, as rows and as blocks of rows, but there are {_axes.Count}");
        }
    }

    /// <summary>The axis from left to right.</summary>
    public SheetAxis Columns => _axes[0];

    /// <summary>The axis from top to bottom.</summary>
    public SheetAxis Rows => _axes.Count > 1 ? _axes[1] : SheetAxis.None;

    /// <summary>The axis from one block of rows to the next.</summary>
    public SheetAxis Blocks => _axes.Count > 2 ? _axes[2] : SheetAxis.None;

    /// <summary>All places of the grid, in the order of reading.</summary>
    public IEnumerable<SweepCell> Cells =>
        from block in Enumerable.Range(0, Blocks.Values.Count)
        from row in Enumerable.Range(0, Rows.Values.Count)
        from column in Enumerable.Range(0, Columns.Values.Count)
        select new SweepCell(column, row, block);

    /// <summary>Places of the grid in which each value of each axis occurs.</summary>
    public IEnumerable<SweepCell> Samples => Cells.Where(c => new[] { c.Column, c.Row, c.Block }.Count(i => i > 0) <= 1);

    /// <summary>Returns the settings of one place of the grid, apart from those that are the same in all.</summary>
    public IEnumerable<SceneSetting> Changes(SweepCell cell) =>
        _axes.Zip([cell.Column, cell.Row, cell.Block], (axis, i) => SceneSetting.Parse($"{axis.Name}={axis.Values[i]}"));

    /// <summary>All that is set in one place of the grid.</summary>
    public IReadOnlyList<SceneSetting> Settings(SweepCell cell) => [.. _fixed, .. Changes(cell)];

    // At commas outside of brackets and quotes.
    private static List<string> Split(string value)
    {
        List<string> parts = [];
        int depth = 0;
        bool isQuoted = false;
        int start = 0;
        for (int i = 0; i <= value.Length; i++)
        {
            char c = i < value.Length ? value[i] : ',';
            isQuoted ^= c == '"' && (i == 0 || value[i - 1] != '\\');
            depth += isQuoted ? 0 : c is '[' or '{' ? 1 : c is ']' or '}' ? -1 : 0;
            if (i == value.Length || (c == ',' && depth == 0 && !isQuoted))
            {
                parts.Add(value[start..i].Trim());
                start = i + 1;
            }
        }

        return parts;
    }
}

/// <summary>A place in the grid of a sweep, from 0.</summary>
internal readonly record struct SweepCell(int Column, int Row, int Block);
