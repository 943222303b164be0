using System.Text.Json.Nodes;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>Two or three numbers.</summary>
internal sealed class VectorFieldViewModel : FieldViewModel
{
    private double[] _numbers;

    /// <summary>An editor of numbers.</summary>
    public VectorFieldViewModel(PanelContext context, CatalogueParameter parameter, string pointer) : base(context, parameter, pointer)
    {
        _numbers = new double[parameter.Kind == "vector3" ? 3 : 2];
        string names = _numbers.Length == 3 ? "panel.axes" : "panel.pair";
        Components = [.. _numbers.Select((_, i) => new ComponentViewModel(SessionTexts.Of($"{names}.{i}"), value => Write(ParameterValues.List(_numbers.Select((n, j) => j == i ? value : n)))))];
    }

    /// <summary>The numbers.</summary>
    public IReadOnlyList<ComponentViewModel> Components { get; }

    /// <inheritdoc/>
    protected override JsonNode Start => ParameterValues.List(_numbers.Length == 3 ? [0, 0, 0] : [1, 1]);

    /// <inheritdoc/>
    protected override void Shown()
    {
        _numbers = ParameterValues.Numbers(Effective, _numbers.Length) ?? _numbers;
        for (int i = 0; i < _numbers.Length; i++)
        {
            Components[i].Show(_numbers[i]);
        }
    }
}
