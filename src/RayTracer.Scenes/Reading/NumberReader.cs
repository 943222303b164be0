using System.Globalization;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Scenes;

/// <summary>Reads numbers, vectors and colours, and checks their ranges.</summary>
internal sealed class NumberReader(DiagnosticBag bag)
{
    public object? Number(RecordParameter parameter, JsonNode node) => Single(parameter.Key, node, parameter);

    public object? Integer(RecordParameter parameter, JsonNode node)
    {
        if (node.Kind != JsonKind.Number)
        {
            bag.Expected(node, "a whole number", parameter.Key);
            return null;
        }

        double value = double.Parse(node.Text, NumberStyles.Float, CultureInfo.InvariantCulture);
        bool isInt = parameter.ValueType == typeof(int);
        if (Math.Abs(value) > (isInt ? int.MaxValue : 1L << 53))
        {
            bag.Error(node, $"{Quotation.Of(parameter.Key)} is too large: {Quotation.Short(node.Text)}", DiagnosticRule.OutOfRange);
            return null;
        }

        if (value != Math.Floor(value))
        {
            bag.Error(node, $"expected a whole number for {Quotation.Of(parameter.Key)}, but found {Quotation.Short(node.Text)}", DiagnosticRule.WrongKind);
            return null;
        }

        return !IsInRange(parameter.Key, node, value, parameter) ? null : isInt ? (int)value : (object)(long)value;
    }

    /// <summary>Reads three whole numbers.</summary>
    public TriangleIndices? Triangle(string key, JsonNode node)
    {
        if (Elements(key, node, 3) is null)
        {
            return null;
        }

        int?[] corners = [.. node.Items.Select(i => WholeNumber(key, i))];
        return corners.Contains(null) ? null : new(corners[0]!.Value, corners[1]!.Value, corners[2]!.Value);
    }

    /// <summary>Reads an element of a list of whole numbers.</summary>
    public int? WholeNumber(string key, JsonNode node)
    {
        if (node.Kind != JsonKind.Number)
        {
            bag.Expected(node, "a whole number", key);
            return null;
        }

        double value = double.Parse(node.Text, NumberStyles.Float, CultureInfo.InvariantCulture);
        if (value != Math.Floor(value) || Math.Abs(value) > int.MaxValue)
        {
            bag.Error(node, $"expected a whole number for {Quotation.Of(key)}, but found {Quotation.Short(node.Text)}", DiagnosticRule.WrongKind);
            return null;
        }

        return (int)value;
    }

    /// <summary>Reads a colour.</summary>
    /// <param name="key">What the colour is for, in messages.</param>
    /// <param name="node">The colour.</param>
    /// <param name="bounds">The parameters whose ranges it must keep to.</param>
    public Rgb? Color(string key, JsonNode node, params ReadOnlySpan<RecordParameter> bounds)
    {
        switch (node.Kind)
        {
            case JsonKind.String when CssColors.Find(node.Text) is { } named:
                return named;
            case JsonKind.String when node.Text.StartsWith('#'):
                return Hex(node);
            case JsonKind.String:
                bag.Unknown(node.Start, $"unknown colour {Quotation.Of(node.Text)}", node.Text, CssColors.Names, "");
                return null;
            case JsonKind.Array:
                return Elements(key, node, 3, bounds) is { } c ? new Rgb(c[0], c[1], c[2]) : null;
            default:
                bag.Expected(node, "a colour", key);
                return null;
        }
    }

    private Rgb? Hex(JsonNode node)
    {
        Rgb? color = CssColors.FromHex(node.Text);
        if (color is null)
        {
            bag.Error(node, $"{Quotation.Of(node.Text)} is not a colour: expected # and three or six hexadecimal digits");
        }

        return color;
    }

    /// <summary>Reads so many numbers in brackets.</summary>
    public float[]? Elements(string key, JsonNode node, int count, params ReadOnlySpan<RecordParameter> bounds)
    {
        if (node.Kind != JsonKind.Array)
        {
            bag.Expected(node, $"an array of {count} numbers", key);
            return null;
        }

        if (node.Items.Count != count)
        {
            bag.Error(node, $"expected {count} numbers for {Quotation.Of(key)}, but found {node.Items.Count}", DiagnosticRule.WrongKind);
            return null;
        }

        float[] values = new float[count];
        bool good = true;
        for (int i = 0; i < count; i++)
        {
            float? value = Single(key, node.Items[i], bounds);
            values[i] = value ?? 0;
            good &= value is not null;
        }

        return good ? values : null;
    }

    private float? Single(string key, JsonNode node, params ReadOnlySpan<RecordParameter> bounds)
    {
        if (node.Kind != JsonKind.Number)
        {
            bag.Expected(node, "a number", key);
            return null;
        }

        float value = float.Parse(node.Text, NumberStyles.Float, CultureInfo.InvariantCulture);
        if (!float.IsFinite(value))
        {
            bag.Error(node, $"{Quotation.Of(key)} is too large: {Quotation.Short(node.Text)} is beyond 3.4e38", DiagnosticRule.OutOfRange);
            return null;
        }

        foreach (RecordParameter parameter in bounds)
        {
            if (!IsInRange(key, node, value, parameter))
            {
                return null;
            }
        }

        return value;
    }

    private bool IsInRange(string key, JsonNode node, double value, RecordParameter bounds)
    {
        string? complaint = bounds.RangeComplaint(value, Quotation.Short(node.Text));
        if (complaint is not null)
        {
            bag.Error(node, $"{Quotation.Of(key)} {complaint}", DiagnosticRule.OutOfRange);
        }

        return complaint is null;
    }
}
