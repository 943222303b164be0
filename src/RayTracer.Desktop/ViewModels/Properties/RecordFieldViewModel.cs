using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>A record within a record, such as the lens of a camera.</summary>
internal sealed class RecordFieldViewModel(PanelContext context, CatalogueParameter parameter, string pointer, CatalogueType type) : FieldViewModel(context, parameter, pointer)
{
    /// <summary>Its parameters.</summary>
    public RecordViewModel Record { get; } = new(context, type, pointer, []);

    /// <inheritdoc/>
    protected override void Shown() => Record.Show(Written);
}
