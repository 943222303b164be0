using System.Text.Json.Nodes;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>A colour: a name or #rrggbb, and the linear numbers that the renderer calculates with.</summary>
internal sealed class ColorFieldViewModel : FieldViewModel
{
    private double[] _linear = [0.5, 0.5, 0.5];

    /// <summary>An editor of a colour.</summary>
    public ColorFieldViewModel(PanelContext context, CatalogueParameter parameter, string pointer) : base(context, parameter, pointer) =>
        Components = [.. _linear.Select((_, i) => new ComponentViewModel(SessionTexts.Of($"panel.channels.{i}"), value => Write(ParameterValues.List(_linear.Select((n, j) => j == i ? value : n)))))];

    /// <summary>The name or #rrggbb; empty where numbers are written.</summary>
    public string Name
    {
        get => ParameterValues.Text(Written) ?? "";
        set
        {
            string tidy = (value ?? "").Trim().ToLowerInvariant();
            if (tidy != Name && ParameterValues.Color(tidy) is not null)
            {
                Write(tidy);
            }

            Tell();
        }
    }

    /// <summary>The colour as #rrggbb.</summary>
    public string Hex => ParameterValues.Hex(_linear);

    /// <summary>The linear numbers.</summary>
    public IReadOnlyList<ComponentViewModel> Components { get; }

    /// <inheritdoc/>
    protected override JsonNode Start => ParameterValues.List(Enumerable.Repeat(Math.Max(Parameter.Minimum ?? 0, Math.Min(0.5, Parameter.Maximum ?? 1)), 3));

    /// <inheritdoc/>
    protected override void Shown()
    {
        _linear = ParameterValues.Color(Effective) ?? _linear;
        for (int i = 0; i < 3; i++)
        {
            Components[i].Show(_linear[i]);
        }
    }
}
