-- | The sky behind a few pixels of a row at once.
--
-- Between two beams that differ little, the beams between them follow by interpolation, and
-- so does the diffuse light where it is even. The stars are searched for once for all of
-- them.
module BlackHole.Trace.SkySpan
  ( SkyNode,
    skyNode,
    spanLength,
    spanStart,
    spanMiddle,
    SkySpan,
    skySpan,
    skyInSpan,
  )
where

import BlackHole.Light.Radiance
import BlackHole.Scene.Camera (pixelMiddle)
import BlackHole.Trace.EnvironmentMap (Evenness (..))
import BlackHole.Trace.RayDifferential
import BlackHole.Trace.Sky
import BlackHole.Trace.SkyLight
import BlackHole.Trace.Tracer
import BlackHole.Vector.XY (XY (..))
import BlackHole.Vector.XYZ ((*^), (^+^), (^-^))
import qualified BlackHole.Vector.XYZ as XYZ

-- | The sky behind a pixel from which the sky behind its neighbours in the row follows:
-- the beam in the frame of the sky, the observed frequency over the sky's, and the diffuse
-- light.
data SkyNode = SkyNode {-# UNPACK #-} !RayDifferential {-# UNPACK #-} !Double Radiance

-- | The sky behind the pixel in a column and a row, if any light arrives from it and it is
-- known for whole pixels.
skyNode :: Tracer -> Int -> Int -> Maybe SkyNode
skyNode traced column row = case tracerSky traced of
  ByDifferential sky -> node <$> skyBeam traced (pixelMiddle column row)
    where
      node (differential, shift) =
        let framed = skyFrame sky differential
         in SkyNode framed shift (skyDiffuse sky shift framed)
  ByDirection _ -> Nothing

-- | How many pixels of a row a span has.
spanLength :: Int
spanLength = 8

-- | The first column of the span that holds a column.
spanStart :: Int -> Int
spanStart column = column - column `rem` spanLength

-- | The middle of the span that begins in a column of a row.
spanMiddle :: Int -> Int -> XY
spanMiddle column row =
  XY (fromIntegral column + 0.5 * fromIntegral spanLength) (fromIntegral row + 0.5)

-- | The sky behind the pixels of a row from one multiple of 'spanLength' to the next.
data SkySpan
  = -- | The beams between two nodes follow from theirs; so does the diffuse light, from that
    -- of both and that in the middle.
    EvenSpan !FilteredSky !SkyNode !SkyNode !Between Radiance
  | -- | The light has to be found for each pixel.
    UnevenSpan

-- | The span between two nodes.
skySpan :: Tracer -> Maybe SkyNode -> Maybe SkyNode -> SkySpan
skySpan traced (Just node@(SkyNode first shift _)) (Just node'@(SkyNode final shift' _))
  | ByDifferential sky <- tracerSky traced,
    straight =
    EvenSpan sky node node' (skyBetween sky first final) $
      skyDiffuse sky (0.5 * (shift + shift')) (beamBetween first final 0.5)
  where
    RayDifferential d a b = first
    RayDifferential d' a' b' = final
    -- The beams change by less than half, and nearly linearly.
    straight =
      within 0.25 (a' ^-^ a) && within 0.25 (b' ^-^ b)
        && within 0.001 ((1 / fromIntegral spanLength) *^ (d' ^-^ d) ^-^ 0.5 *^ (a ^+^ a'))
    within part change = XYZ.dot change change < part * min (XYZ.dot a a) (XYZ.dot b b)
skySpan _ _ _ = UnevenSpan

-- | The light of the sky behind a pixel, given the span that holds it.
skyInSpan :: Tracer -> SkySpan -> Int -> Int -> Radiance
skyInSpan traced UnevenSpan column row = patchLight (pixelSky traced column row)
skyInSpan _ (EvenSpan sky node node' between middle) column _ =
  maybe diffuse (\stars -> diffuse <+> stars g beam) (betweenStars between)
  where
    SkyNode first shift light = node
    SkyNode final shift' light' = node'
    diffuse = case betweenDiffuse between of
      Linear -> mixRadiance t light light'
      LinearByHalves
        | t < 0.5 -> mixRadiance (2 * t) light middle
        | otherwise -> mixRadiance (2 * t - 1) middle light'
      Uneven -> skyDiffuse sky g beam
    t = fromIntegral (column `rem` spanLength) / fromIntegral spanLength
    g = shift + t * (shift' - shift)
    beam = beamBetween first final t

-- | The beam at a fraction of the way along a span, by Hermite's interpolation of the
-- direction.
beamBetween :: RayDifferential -> RayDifferential -> Double -> RayDifferential
beamBetween (RayDifferential d a b) (RayDifferential d' a' b') t =
  RayDifferential direction (alongX a a') (alongX b b')
  where
    n = fromIntegral spanLength
    s = 1 - t
    along =
      ((1 + 2 * t) * s * s) *^ d
        ^+^ (t * s * s * n) *^ a
        ^+^ (t * t * (3 - 2 * t)) *^ d'
        ^-^ (t * t * s * n) *^ a'
    direction = (1 / XYZ.norm along) *^ along
    alongX p p' = s *^ p ^+^ t *^ p'
