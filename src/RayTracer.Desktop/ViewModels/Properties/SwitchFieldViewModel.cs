using System.Text.Json;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>On or off.</summary>
internal sealed class SwitchFieldViewModel(PanelContext context, CatalogueParameter parameter, string pointer) : FieldViewModel(context, parameter, pointer)
{
    private bool _isOn;

    /// <summary>Whether it is on.</summary>
    public bool IsOn
    {
        get => _isOn;
        set
        {
            if (!IsTelling && Set(ref _isOn, value))
            {
                Write(value);
            }
        }
    }

    /// <inheritdoc/>
    protected override void Shown() => _isOn = Effective?.GetValueKind() == JsonValueKind.True;
}
